// Unit vectors in 32 bits: octahedral map, 2 x snorm16 (Cigolle et al. 2014, JCGT 3(2)). Error below 0.004 degrees.
#ifndef GNOMON_OCTAHEDRAL_GLSL
#define GNOMON_OCTAHEDRAL_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
#include <glm/gtc/packing.hpp>
namespace gnomon {
using glm::packSnorm2x16;
using glm::unpackSnorm2x16;
#endif

inline_function vec2 octahedral_fold(vec2 p) {
  vec2 folded = vec2(1.0f - abs(p.y), 1.0f - abs(p.x));
  return vec2(p.x >= 0.0f ? folded.x : -folded.x, p.y >= 0.0f ? folded.y : -folded.y);
}

inline_function uint pack_normal(vec3 n) {
  vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
  return packSnorm2x16(n.z < 0.0f ? octahedral_fold(p) : p);
}

inline_function vec3 unpack_normal(uint packed_normal) {
  vec2 p = unpackSnorm2x16(packed_normal);
  float z = 1.0f - abs(p.x) - abs(p.y);
  vec2 xy = z < 0.0f ? octahedral_fold(p) : p;
  return normalize(vec3(xy.x, xy.y, z));
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
