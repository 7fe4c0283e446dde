// One layer for everything.
#include "shadow/map/glsl/layers.glsl"

uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  return only_layer(views, position_ws, layers, weights);
}
