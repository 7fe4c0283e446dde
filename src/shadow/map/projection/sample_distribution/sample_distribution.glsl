// The split of the point's distance. The last one ends at the farthest sample: what rounding puts beyond it belongs to it.
#include "shadow/map/glsl/layers.glsl"

uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  float depth = dot(views.map.eye_depth, vec4(position_ws, 1.0));
  uint layer = 0u;
  while (layer + 1u < views.map.layers && depth >= views.v[layer].interval_m.y) ++layer;
  one_layer(layer, layers, weights);
  vec3 ndc = (views.v[layer].raster.clip_from_world * vec4(position_ws, 1.0)).xyz;
  // Outside the map no caster lies before the point.
  return views.v[layer].raster.in_use != 0u && all(lessThanEqual(abs(ndc.xy), vec2(1.0))) ? 1u : 0u;
}
