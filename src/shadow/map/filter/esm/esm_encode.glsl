// c z, whose exponentials are averaged (Annen et al. 2008, eq. 7; log space: Lauritzen 2008). Centred on the middle of the
// range: exp(c (z - 1/2)) stays within floats for twice the c.
#define MOMENTS float
#define MOMENTS_LOG (filter_params.space == space_log)
#include "shadow/map/filter/esm/esm_scale.glsl"
float encode(float linear, vec2 slope, float depth_range_m, FilterParams params) {
  float exponent = esm_exponent(params.c, params.unit, params.space, depth_range_m) * (linear - 0.5);
  return params.space == space_exponential ? exp(exponent) : exponent;
}
vec4 stored(float blurred, FilterParams params) { return vec4(blurred); }
