// Warps of depth, and Chebyshev's bound on what is warped; for C++ (tests) and shaders.
#ifndef GNOMON_EVSM_WARP_GLSL
#define GNOMON_EVSM_WARP_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
using glm::exp;
#endif

// What the squares of exp(c) need: exp(2 x 42) = 3e36 in a 32-bit float (3.4e38), exp(2 x 5.54) = 64860 in a 16-bit one
// (65504).
inline_function float evsm_exponent(float exponent, bool half_floats) { return min(exponent, half_floats ? 5.54f : 42.0f); }

// {exp(c+ z), -exp(-c- z)}, z in [-1, 1] (Lauritzen and McCool 2008, section 4).
inline_function vec2 evsm_warp(float linear, vec2 exponents) {
  float z = 2.0f * clamp(linear, 0.0f, 1.0f) - 1.0f;
  return vec2(exp(exponents.x * z), -exp(-exponents.y * z));
}

// Chebyshev's bound from the moments of one warp. `least_deviation`: of the unwarped z; the warp stretches it by its
// derivative, exponent times the warped value. All is divided by the larger of mean and receiver before anything is squared:
// the quotient of two warps spans exp(168), whose square no float holds, and 0 times infinity is what must not happen.
inline_function float evsm_bound(float mean, float mean_square, float receiver, float exponent, float least_deviation) {
  if (receiver <= mean) return 1.0f;
  float scale = max(max(abs(mean), abs(receiver)), 1e-37f);
  float m = mean / scale, r = receiver / scale;
  float m2 = min(mean_square / scale / scale, 1e30f);
  float least = min(exponent * abs(r) * least_deviation, 1e15f);
  float variance = max(m2 - m * m, least * least + 1e-12f);
  return variance / (variance + (r - m) * (r - m));
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
