// z, z^2, z^3, z^4.
#define MOMENTS vec4
#include "shadow/map/filter/msm/msm_moments.glsl"
vec4 encode(float linear, vec2 slope, float depth_range_m, FilterParams params) { return msm_moments(2.0 * linear - 1.0); }
vec4 stored(vec4 blurred, FilterParams params) { return params.format == format_unorm16 ? msm_quantized(blurred) : blurred; }
