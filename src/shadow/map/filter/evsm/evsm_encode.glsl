// Mean and mean square of both warps of depth.
#define MOMENTS vec4
#include "shadow/map/filter/evsm/evsm_warp.glsl"
vec4 encode(float linear, vec2 slope, float depth_range_m, FilterParams params) {
  bool half_floats = params.format == format_float16;
  vec2 warped =
      evsm_warp(linear, vec2(evsm_exponent(params.positive, half_floats), evsm_exponent(params.negative, half_floats)));
  return vec4(warped.x, warped.x * warped.x, warped.y, warped.y * warped.y);
}
vec4 stored(vec4 blurred, FilterParams params) {
  // Rounding of the weights' sum may lead past the largest half float, which is stored as infinity.
  return params.format == format_float16 ? clamp(blurred, vec4(-65504.0), vec4(65504.0)) : blurred;
}
