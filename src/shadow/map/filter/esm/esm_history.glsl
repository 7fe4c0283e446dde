#include "shadow/map/filter/esm/esm_scale.glsl"
// The logarithm of the mean, over c, is taken for the depth: exact for one surface, and for any where only the offset differs.
vec4 with_depth_changed(vec4 stored, float scale, float offset, vec2 depth_range_m, FilterParams params) {
  float c_before = esm_exponent(params.c, params.unit, params.space, depth_range_m.x);
  float c_now = esm_exponent(params.c, params.unit, params.space, depth_range_m.y);
  float logarithm = params.space == space_log ? stored.x : log(max(stored.x, 1e-37));
  float changed = c_now * (scale * (logarithm / c_before + 0.5) + offset - 0.5);
  return vec4(params.space == space_log ? changed : exp(clamp(changed, -80.0, 80.0)));
}
