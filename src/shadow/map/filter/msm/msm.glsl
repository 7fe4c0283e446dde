// The sharpest bound that four moments allow (Peters and Klein 2015).
#define GNOMON_FILTER_FOOTPRINT
#include "shadow/map/filter/msm/msm_moments.glsl"
#include "shadow/map/glsl/moments.glsl"

float filter_radius(FilterParams params) { return float(params.blur) + 1.0; }

float lit(uint map_image, MapSample at, FilterParams params) {
  vec4 moments = moments_at(map_image, at, params.mips != 0u);
  bool quantized = params.format == format_unorm16;
  if (quantized) moments = msm_unquantized(moments);
  float receiver = clamp(at.linear - params.depth_bias * 0.01 / at.depth_range_m, 0.0, 1.0);
  float bias = min(params.moment_bias * (quantized ? 6e-5 : 3e-7), 0.5);
  return reduce_bleeding(1.0 - msm_shadow(moments, 2.0 * receiver - 1.0, bias), params.bleeding);
}
