// Chebyshev's one-sided inequality bounds the lit share of the filtered region (Donnelly and Lauritzen 2006, eq. 5).
#define GNOMON_FILTER_FOOTPRINT
#include "shadow/map/glsl/moments.glsl"

float filter_radius(FilterParams params) { return float(params.blur) + 1.0; }

float lit(uint map_image, MapSample at, FilterParams params) {
  vec2 moments = moments_at(map_image, at, params.mips != 0u).xy;
  float receiver = clamp(at.linear, 0.0, 1.0);
  float least = params.min_variance * 0.01 / at.depth_range_m;
  return reduce_bleeding(chebyshev(moments.x, moments.y, receiver, least * least + 1e-12), params.bleeding);
}
