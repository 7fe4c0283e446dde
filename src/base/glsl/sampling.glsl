// Low-discrepancy sequence, hashes, directions toward a light and robust ray origins: the same text for the ray-tracing
// pipeline, ray-traced techniques and Embree (include base/glsl/shared.glsl first).
#ifndef GNOMON_SAMPLING_GLSL
#define GNOMON_SAMPLING_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// PCG output permutation as a hash (Jarzynski and Olano 2020, JCGT 9(3)).
inline_function uint hash_uint(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// In [0, 1): the upper 24 bits, which a float holds exactly.
inline_function float unit_float(uint bits) { return float(bits >> 8u) * (1.0f / 16777216.0f); }

inline_function uint reverse_bits(uint bits) {
  bits = (bits << 16u) | (bits >> 16u);
  bits = ((bits & 0x00ff00ffu) << 8u) | ((bits & 0xff00ff00u) >> 8u);
  bits = ((bits & 0x0f0f0f0fu) << 4u) | ((bits & 0xf0f0f0f0u) >> 4u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xccccccccu) >> 2u);
  return ((bits & 0x55555555u) << 1u) | ((bits & 0xaaaaaaaau) >> 1u);
}

// Point `index` of the (0,2)-sequence of van der Corput and Sobol, randomised by digit scrambling (Kollig and Keller 2002).
inline_function vec2 scrambled_02_sequence(uint index, uint scramble_x, uint scramble_y) {
  uint sobol = 0u;
  uint direction = 0x80000000u;
  for (uint rest = index; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) sobol ^= direction;
    direction ^= direction >> 1u;
  }
  return vec2(unit_float(reverse_bits(index) ^ scramble_x), unit_float(sobol ^ scramble_y));
}

// Area-preserving map of the unit square onto the unit disc (Shirley and Chiu 1997).
inline_function vec2 concentric_disc(vec2 square) {
  float a = 2.0f * square.x - 1.0f;
  float b = 2.0f * square.y - 1.0f;
  if (a == 0.0f && b == 0.0f) return vec2(0.0f, 0.0f);
  float r = a;
  float phi = 0.785398163f * (b / a);
  if (abs(a) <= abs(b)) {
    r = b;
    phi = 1.570796327f - 0.785398163f * (a / b);
  }
  return vec2(r * cos(phi), r * sin(phi));
}

// A point on the same side of its surface as `normal` (unit, the side the ray leaves on), far enough that the ray cannot hit
// its own surface, near enough that no shadow detaches. Three errors add up, in metres along the normal:
// - rounding of coordinates in the chain vertex -> depth -> position -> object space: up to 17 * 2^-24 of the largest one
//   (measured: 10 for the inverse projection, the rest for the transforms); 2^-19 has a margin of two;
// - the rasteriser moves vertices to a grid of 1/256 pixel, which tilts the depth of a surface seen at a grazing angle: up to
//   1/512 pixel sideways, 3.8e-6 of the eye's distance at 600 lines and 60 degrees; 2^-17 = 7.6e-6 covers 300 lines;
// - the distance of the ray's start from the plane of a triangle that is `extents.x` metres large (scene/ray_extents.h),
//   computed in floats by the tracer: 2^-23 of it (measured: 2^-24 suffices).
// Coordinates near 0 may be differences of larger ones: at least `extents.y` counts, a metre or all of a smaller scene.
// At 10 m, in a scene of metre-sized triangles, that is 0.1 mm: a two-hundredth of a pixel.
inline_function vec3 ray_origin(vec3 position_ws, vec3 normal_ws, float eye_distance, vec2 extents) {
  float largest = max(max(abs(position_ws.x), abs(position_ws.y)), max(abs(position_ws.z), extents.y));
  float offset = largest * 1.9073486328125e-06f + eye_distance * 7.62939453125e-06f + extents.x * 1.1920928955078125e-07f;
  return position_ws + normal_ws * offset;
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
