#define GNOMON_PROJECTION_PARABOLOID

// The half that the point lies in.
uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  vec4 axis = transpose(views.v[0].raster.clip_from_world)[2];
  layers[0] = layers[1] = dot(axis, vec4(position_ws, 1.0)) >= 0.0 ? 0u : 1u;
  weights[0] = 1.0;
  weights[1] = 0.0;
  return 1u;
}
