// The face that the point lies behind: +x, -x, +y, -y, +z, -z.
#include "shadow/map/glsl/layers.glsl"

uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  vec3 offset = position_ws - views.v[0].origin_ws;
  vec3 size = abs(offset);
  uint axis = size.x >= size.y && size.x >= size.z ? 0u : size.y >= size.z ? 1u : 2u;
  return one_layer(2u * axis + (offset[axis] < 0.0 ? 1u : 0u), layers, weights);
}
