// Whose texel is it? Hourcade and Nicolas 1985.
#define GNOMON_FILTER_OBJECT
#include "shadow/map/glsl/compare.glsl"

float compare_id(uint map_image, MapSample at, FilterParams params, ivec2 texel) {
  // Outside the map is lit.
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(int(at.size))))) return 1.0;
  uint id = texelFetch(images_2d_array_uint[nonuniformEXT(at.object_image)], ivec3(texel, at.layer), 0).x;
  if (id == 0u) return 1.0;
  vec2 uv = (vec2(texel) + 0.5) / at.size;
  float stored = texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texel, at.layer), 0).x;
  if (id != (params.parts == parts_object ? at.object : at.item)) {
    return params.priority != 0u && stored >= depth_at(at, uv) ? 1.0 : 0.0;
  }
  if (params.within == within_lit) return 1.0;
  float receiver = at.linear + dot(at.linear_gradient, uv - at.uv);
  float nearer_m = (receiver - linear_depth(at.linear_numerator, at.linear_denominator, uv, stored)) * at.depth_range_m;
  return nearer_m > params.within_bias * at.texel_m ? 0.0 : 1.0;
}

float lit(uint map_image, MapSample at, FilterParams params) {
  ivec2 first = ivec2(floor(at.uv * at.size - 0.5 * float(params.size - 1)));
  float sum = 0.0;
  for (int y = 0; y < params.size; ++y) {
    for (int x = 0; x < params.size; ++x) sum += compare_id(map_image, at, params, first + ivec2(x, y));
  }
  return sum / float(params.size * params.size);
}

float filter_radius(FilterParams params) { return 0.5 * float(params.size); }
