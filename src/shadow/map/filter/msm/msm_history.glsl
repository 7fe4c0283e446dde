#include "shadow/map/filter/msm/msm_moments.glsl"
// Powers of s z + o, multiplied out.
vec4 with_depth_changed(vec4 stored, float scale, float offset, vec2 depth_range_m, FilterParams params) {
  bool quantized = params.format == format_unorm16;
  vec4 b = quantized ? msm_unquantized(stored) : stored;
  // Depth runs from -1 to 1.
  float s = scale, o = scale + 2.0 * offset - 1.0;
  vec4 moved;
  moved.x = s * b.x + o;
  moved.y = s * s * b.y + 2.0 * s * o * b.x + o * o;
  moved.z = s * s * s * b.z + 3.0 * s * s * o * b.y + 3.0 * s * o * o * b.x + o * o * o;
  moved.w =
      s * s * s * s * b.w + 4.0 * s * s * s * o * b.z + 6.0 * s * s * o * o * b.y + 4.0 * s * o * o * o * b.x + o * o * o * o;
  return quantized ? msm_quantized(moved) : moved;
}
