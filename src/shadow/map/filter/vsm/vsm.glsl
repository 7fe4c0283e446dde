// Chebyshev's one-sided inequality bounds the lit share of the filtered region (Donnelly and Lauritzen 2006, eq. 5).
#define GNOMON_FILTER_FOOTPRINT
#include "shadow/map/glsl/moments.glsl"

float filter_radius(FilterParams params) { return float(params.blur) + 1.0; }

float lit(uint map_image, MapSample at, FilterParams params) {
  vec2 moments = moments_at(map_image, at).xy;
  float receiver = clamp(at.linear, 0.0, 1.0);
  if (receiver <= moments.x) return 1.0;
  float least = params.min_variance * 0.01 / at.depth_range_m;
  // Rounding can make the difference of two nearly equal numbers negative: the clamp is also what keeps it a variance.
  float variance = max(moments.y - moments.x * moments.x, least * least + 1e-12);
  float beyond = receiver - moments.x;
  return reduce_bleeding(variance / (variance + beyond * beyond), params.bleeding);
}
