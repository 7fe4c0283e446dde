// The default kernel around visibility(): one evaluation per surface in a pixel, per sample on edges.
layout(buffer_reference, scalar) readonly buffer ProjectionParamsRef { ProjectionParams v; };
layout(buffer_reference, scalar) readonly buffer FilterParamsRef { FilterParams v; };
layout(buffer_reference, scalar) readonly buffer BiasParamsRef { BiasParams v; };

layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  ShadowViews views;
  ProjectionParamsRef projection;
  FilterParamsRef map_filter;
  BiasParamsRef bias;
  Floats mask;
  uint light;
  uint map_image;
};
layout(local_size_x = 8, local_size_y = 8) in;

float evaluate(uvec2 pixel, uint s) {
  Surface surface;
  if (!load_surface(frame, pixel, s, surface)) return 1.0;
  LightShape shape = frame.v.lights.v[light].shape;
  if (!receives_light(shape, surface.position_ws, surface.geometric_normal_ws)) return 0.0;
  vec3 to_light = direction_to_light(shape, surface.position_ws);
  return visibility(views, map_image, projection.v, map_filter.v, bias.v, surface.position_ws, surface.geometric_normal_ws, to_light);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  uvec2 size = frame.v.camera.size;
  if (any(greaterThanEqual(pixel, size))) return;
  uint samples = frame.v.camera.samples;
  uint share = frame.v.surface.share.v[pixel.y * size.x + pixel.x];
  uint first = (pixel.y * size.x + pixel.x) * samples;
  float values[8];
  for (uint s = 0u; s < samples; ++s) {
    uint leader = sharing_sample(share, s);
    values[s] = leader < s ? values[leader] : evaluate(pixel, s);
    mask.v[first + s] = values[s];
  }
}
