// Mean and mean square of depth, with the share that a plane adds within a texel (Donnelly and Lauritzen 2006, eq. 7).
#define MOMENTS vec2
#define MOMENTS_NEED_SLOPE
vec2 encode(float linear, vec2 slope, float depth_range_m, FilterParams params) {
  float within = params.slope_term != 0u ? 0.25 * dot(slope, slope) : 0.0;
  return vec2(linear, linear * linear + within);
}
vec4 stored(vec2 blurred, FilterParams params) { return vec4(blurred, 0.0, 0.0); }
