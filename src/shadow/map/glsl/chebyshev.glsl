// Bounds from two moments, for C++ (tests) and shaders.
#ifndef GNOMON_CHEBYSHEV_GLSL
#define GNOMON_CHEBYSHEV_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// Most that can lie at or beyond `receiver` of what has this mean and mean square: Chebyshev's one-sided inequality (Donnelly
// and Lauritzen 2006, eq. 5). least_variance > 0: rounding can make the difference of two nearly equal numbers negative, and
// the clamp is what keeps it a variance.
inline_function float chebyshev(float mean, float mean_square, float receiver, float least_variance) {
  if (receiver <= mean) return 1.0f;
  float variance = max(mean_square - mean * mean, least_variance);
  float beyond = receiver - mean;
  return variance / (variance + beyond * beyond);
}

// Values below `amount` become 0 and the rest is stretched over [0, 1]: what little light two overlapping shadows let through
// is taken away, and with it some of every penumbra (Lauritzen 2007).
inline_function float reduce_bleeding(float p, float amount) {
  return clamp((p - amount) / max(1.0f - amount, 1e-6f), 0.0f, 1.0f);
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
