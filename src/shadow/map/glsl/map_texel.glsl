// Reading any image that belongs to a shadow map, for display.
#ifndef GNOMON_MAP_TEXEL_GLSL
#define GNOMON_MAP_TEXEL_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#else
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#endif

shared_constant uint k_map_depth = 0u;
shared_constant uint k_map_depth_samples = 1u;  // the first of several
shared_constant uint k_map_values = 2u;         // what a filter makes of depths
shared_constant uint k_map_table = 3u;          // sums modulo 2^32, as shares of that
shared_constant uint k_map_objects = 4u;        // index + 1

struct MapProbeArguments {
  uint64_t result;
  uint image, kind, layer, size;
  uint texel_x, texel_y;
};

// Of one layer: the value at a texel, and the range of each channel as order_preserving() makes it. Of depth maps, texels
// without a caster do not count.
struct MapProbe {
  vec4 value;
  uvec4 least, most;
};

// Floats as whole numbers in the same order, so that atomic minima and maxima compare them; and back.
inline_function uint order_preserving(float value) {
  uint bits = floatBitsToUint(value);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
inline_function float order_restored(uint ordered) {
  return uintBitsToFloat((ordered & 0x80000000u) != 0u ? ordered & 0x7fffffffu : ~ordered);
}

#ifdef __cplusplus
}  // namespace gnomon
#else
vec4 map_texel(uint image, uint kind, uint layer, ivec2 texel) {
  ivec3 at = ivec3(texel, layer);
  if (kind == k_map_depth_samples) return texelFetch(images_2d_ms_array[image], at, 0);
  if (kind == k_map_table) return vec4(texelFetch(images_2d_array_uint[image], at, 0)) / 4294967296.0;
  if (kind == k_map_objects) return vec4(texelFetch(images_2d_array_uint[image], at, 0));
  return texelFetch(images_2d_array[image], at, 0);
}
#endif

#endif
