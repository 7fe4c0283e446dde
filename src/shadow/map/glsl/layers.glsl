// What project() answers (shadow/map/glsl/visibility.glsl): which layers hold a point and how much each counts.
#ifndef GNOMON_LAYERS_GLSL
#define GNOMON_LAYERS_GLSL
#include "shadow/map/glsl/map_data.glsl"

uint one_layer(uint layer, out uint layers[2], out float weights[2]) {
  layers[0] = layers[1] = layer;
  weights[0] = 1.0;
  weights[1] = 0.0;
  return 1u;
}

// Of a map with a single layer: outside it, and behind a perspective's apex, is lit.
uint only_layer(ShadowViews views, vec3 position_ws, out uint layers[2], out float weights[2]) {
  one_layer(0u, layers, weights);
  vec4 clip = views.v[0].raster.clip_from_world * vec4(position_ws, 1.0);
  return clip.w > 0.0 && all(lessThanEqual(abs(clip.xy), vec2(clip.w))) ? 1u : 0u;
}

#endif
