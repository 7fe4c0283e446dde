#include "shadow/map/filter/evsm/evsm_warp.glsl"
// exp(c (s z + o)) = exp(c z)^s exp(c o), and so for the means: exact for one surface, and for any where only the offset
// differs.
vec4 with_depth_changed(vec4 stored, float scale, float offset, vec2 depth_range_m, FilterParams params) {
  bool half_floats = params.format == format_float16;
  float positive = evsm_exponent(params.positive, half_floats), negative = evsm_exponent(params.negative, half_floats);
  // Depth is warped from [-1, 1].
  vec4 c = vec4(positive, 2.0 * positive, -negative, -2.0 * negative) * (scale + 2.0 * offset - 1.0);
  vec4 most = vec4(positive, 2.0 * positive, negative, 2.0 * negative), sign = vec4(1.0, 1.0, -1.0, 1.0);
  return sign * exp(clamp(scale * log(max(sign * stored, vec4(1e-37))) + c, -most, most));
}
