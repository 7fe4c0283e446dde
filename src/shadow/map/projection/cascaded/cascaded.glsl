// The cascade of a point, and the next one where they blend.
#include "shadow/map/glsl/layers.glsl"

bool inside_layer(ShadowView view, vec3 position_ws, out float to_edge) {
  vec4 clip = view.raster.clip_from_world * vec4(position_ws, 1.0);
  vec3 ndc = clip.xyz / max(clip.w, 1e-6);  // warped maps: behind the apex lies outside
  float edge = 1.0 - 2.0 * view.border / view.size;
  to_edge = (edge - max(abs(ndc.x), abs(ndc.y))) / max(edge, 1e-3);
  // Before the near plane the map does not know what casts.
  return to_edge >= 0.0 && ndc.z >= 0.0 && ndc.z <= 1.0;
}

uint two_layers(uint layer, float share, out uint layers[2], out float weights[2]) {
  layers[0] = layer;
  layers[1] = layer + 1u;
  weights[0] = share;
  weights[1] = 1.0 - share;
  return 2u;
}

// Outside every map is lit.
uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  uint count = views.map.layers;
  one_layer(0u, layers, weights);
  float depth = dot(views.map.eye_depth, vec4(position_ws, 1.0));
  if (count == 0u || depth > views.v[count - 1u].interval_m.y) return 0u;
  float to_edge, next_edge;
  if (params.selection == selection_interval) {
    uint layer = 0u;
    while (layer + 1u < count && depth >= views.v[layer].interval_m.y) ++layer;
    if (!inside_layer(views.v[layer], position_ws, to_edge)) return 0u;
    vec2 interval = views.v[layer].interval_m;
    float left = (interval.y - depth) / max(params.blend * (interval.y - interval.x), 1e-6);
    bool blends = layer + 1u < count && left < 1.0 && inside_layer(views.v[layer + 1u], position_ws, next_edge);
    return blends ? two_layers(layer, left, layers, weights) : one_layer(layer, layers, weights);
  }
  for (uint layer = 0u; layer < count; ++layer) {
    if (!inside_layer(views.v[layer], position_ws, to_edge)) continue;
    float left = to_edge / max(params.blend, 1e-6);
    bool blends = layer + 1u < count && left < 1.0 && inside_layer(views.v[layer + 1u], position_ws, next_edge);
    return blends ? two_layers(layer, left, layers, weights) : one_layer(layer, layers, weights);
  }
  return 0u;
}
