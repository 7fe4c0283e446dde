// The lesser of the bounds of both warps (Lauritzen and McCool 2008).
#define GNOMON_FILTER_FOOTPRINT
#include "shadow/map/filter/evsm/evsm_warp.glsl"
#include "shadow/map/glsl/moments.glsl"

float filter_radius(FilterParams params) { return float(params.blur) + 1.0; }

float lit(uint map_image, MapSample at, FilterParams params) {
  vec4 moments = moments_at(map_image, at, params.mips != 0u);
  bool half_floats = params.format == format_float16;
  vec2 exponents = vec2(evsm_exponent(params.positive, half_floats), evsm_exponent(params.negative, half_floats));
  vec2 receiver = evsm_warp(at.linear, exponents);
  // Depth is warped from [-1, 1]: twice as steep.
  float least = 2.0 * params.min_variance * 0.01 / at.depth_range_m;
  float bound = evsm_bound(moments.x, moments.y, receiver.x, exponents.x, least);
  if (params.moments == moments_four) bound = min(bound, evsm_bound(moments.z, moments.w, receiver.y, exponents.y, least));
  return reduce_bleeding(bound, params.bleeding);
}
