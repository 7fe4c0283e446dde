// Four moments of depth and the sharpest bound that they allow; for C++ (tests) and shaders. Depth z runs from -1 to 1.
#ifndef GNOMON_MSM_MOMENTS_GLSL
#define GNOMON_MSM_MOMENTS_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
using glm::vec4;
#endif

inline_function vec4 msm_moments(float z) {
  float square = z * z;
  return vec4(z, square, z * square, square * square);
}

// Odd and even moments are each turned so that what depths can yield fills the unit square: of all affine transforms the one
// that loses least to 16 bits (Peters, Muenstermann, Wetzstein and Klein 2017, section 2.3). Affine: blur and texture unit may
// work on it.
inline_function vec4 msm_quantized(vec4 b) {
  return vec4(1.5f * b.x - 2.0f * b.z + 0.5f, 4.0f * (b.y - b.w), 0.8660254038f * b.x - 0.3849001795f * b.z + 0.5f,
              0.5f * (b.y + b.w));
}
inline_function vec4 msm_unquantized(vec4 q) {
  float x = q.x - 0.5f, z = q.z - 0.5f;
  return vec4(1.7320508076f * z - 0.3333333333f * x, q.w + 0.125f * q.y, 1.2990381057f * z - 0.75f * x, q.w - 0.125f * q.y);
}

// Of the distribution {z, x1, x2} that has these moments (Gauss quadrature with one node given), the weight at a node x is
// 1 / K(x), K(x) = 1 + y1(x)^2 / d1 + y2(x)^2 / d2: always in (0, 1], whatever rounding did to x.
inline_function float msm_weight(vec4 b, float l21, float d1, float d2, float x) {
  float y1 = x - b.x;
  float y2 = x * x - b.y - l21 * y1;
  return 1.0f / (1.0f + y1 * y1 / d1 + y2 * y2 / d2);
}

// Least share of the depths that lies before z: the Hamburger four-moment bound (Peters and Klein 2015, algorithm 3; there the
// weights come from divided differences, which cancel where nodes meet). Defined for every input: the two pivots are clamped,
// since rounded moments may belong to no distribution at all.
inline_function float msm_shadow(vec4 moments, float z, float moment_bias) {
  // Toward a distribution of greatest spread, by as much as rounding may have moved the moments (2017, section 2.4).
  vec4 b = moments + moment_bias * (vec4(0.0f, 0.628f, 0.0f, 0.628f) - moments);
  // Hankel matrix {1 b1 b2; b1 b2 b3; b2 b3 b4} = L diag(1, d1, d2) L^T.
  float d1 = max(b.y - b.x * b.x, 1e-7f);
  float l21 = (b.z - b.x * b.y) / d1;
  float d2 = max(b.w - b.y * b.y - l21 * l21 * d1, 1e-9f);
  // c = d2 times the solution for (1, z, z^2): the other two nodes are the roots of c0 + c1 x + c2 x^2.
  float y1 = z - b.x;
  float c2 = z * z - b.y - l21 * y1;
  float c1 = y1 / d1 * d2 - l21 * c2;
  float c0 = d2 - b.x * c1 - b.y * c2;
  // Half way into a root that lies at infinity (c2 = 0) both quotients stay finite, and a node that far out has no weight.
  float q = -0.5f * (c1 + (c1 < 0.0f ? -1.0f : 1.0f) * sqrt(max(c1 * c1 - 4.0f * c0 * c2, 0.0f)));
  float safe_c2 = abs(c2) < 1e-20f ? 1e-20f : c2;
  float safe_q = abs(q) < 1e-20f ? 1e-20f : q;
  float a = clamp(q / safe_c2, -1000.0f, 1000.0f), e = clamp(c0 / safe_q, -1000.0f, 1000.0f);
  float nearest = min(a, e), farthest = max(a, e);
  if (z <= nearest) return 0.0f;
  if (z <= farthest) return msm_weight(b, l21, d1, d2, nearest);
  return 1.0f - msm_weight(b, l21, d1, d2, z);
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
