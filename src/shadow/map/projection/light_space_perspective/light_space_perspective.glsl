// One layer for everything; outside the map, and behind the warp's apex, is lit.
uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2]) {
  vec4 clip = views.v[0].raster.clip_from_world * vec4(position_ws, 1.0);
  layers[0] = layers[1] = 0u;
  weights[0] = 1.0;
  weights[1] = 0.0;
  return clip.w > 0.0 && all(lessThanEqual(abs(clip.xy), vec2(clip.w))) ? 1u : 0u;
}
