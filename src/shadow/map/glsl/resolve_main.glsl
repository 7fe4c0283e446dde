// The default kernel around visibility(): one evaluation per surface in a pixel, per sample on edges.
#ifdef GNOMON_FILTER_FOOTPRINT
#include "shadow/map/glsl/pixel_footprint.glsl"
#endif

layout(buffer_reference, scalar) readonly buffer ProjectionParamsRef { ProjectionParams v; };
layout(buffer_reference, scalar) readonly buffer FilterParamsRef { FilterParams v; };
layout(buffer_reference, scalar) readonly buffer BiasParamsRef { BiasParams v; };

layout(constant_id = 0) const uint k_samples = 1;
layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  ShadowViews views;
  ProjectionParamsRef projection;
  FilterParamsRef map_filter;
  BiasParamsRef bias;
  Floats mask;
  uint light;
  uint map_image;
  uint object_image;
  uint unused;
};
layout(local_size_x = 8, local_size_y = 8) in;

// What all pixels share, read once.
struct Uniforms {
  CameraData camera;
  SurfaceData surface;
  LightShape shape;
  ProjectionParams projection;
  FilterParams map_filter;
  BiasParams bias;
};

float evaluate(Uniforms uniforms, uvec2 pixel, uint s) {
  Surface surface;
  if (!load_surface(uniforms.camera, uniforms.surface, pixel, s, surface)) return 1.0;
  if (!receives_light(uniforms.shape, surface.position_ws, surface.geometric_normal_ws)) return 0.0;
  Receiver receiver;
  receiver.position_ws = surface.position_ws;
  receiver.normal_ws = surface.geometric_normal_ws;
  receiver.to_light = direction_to_light(uniforms.shape, surface.position_ws);
  receiver.pixel_x_ws = receiver.pixel_y_ws = vec3(0.0);
  receiver.noise = vec2(0.0);
  receiver.object = receiver.item = receiver.object_image = 0u;
#ifdef GNOMON_FILTER_OBJECT
  uint index = sample_index(uniforms.camera, pixel, s);
  uint item = uniforms.surface.item.v[index];
  receiver.item = item + 1u;
  receiver.object = frame.v.scene.items.v[item].object + 1u;
  receiver.object_image = object_image;
#endif
#ifdef GNOMON_FILTER_FOOTPRINT
  if (uniforms.map_filter.mips != 0u) {
    receiver.pixel_x_ws = to_neighbour(uniforms.camera, ivec2(pixel) + ivec2(1, 0), s, surface);
    receiver.pixel_y_ws = to_neighbour(uniforms.camera, ivec2(pixel) + ivec2(0, 1), s, surface);
  }
#endif
#ifdef GNOMON_FILTER_NOISE
  // Interleaved gradient noise (Jimenez 2014), and the same shifted: neighbours differ as much as they can.
  vec2 at = vec2(pixel) + 0.5;
  receiver.noise =
      fract(52.9829189 * fract(vec2(dot(at, vec2(0.06711056, 0.00583715)), dot(at + 47.0, vec2(0.00583715, 0.06711056)))));
#endif
  return visibility(views, map_image, uniforms.projection, uniforms.map_filter, uniforms.bias, receiver);
}

void resolve_samples(Uniforms uniforms, uvec2 pixel) {
  uint index = pixel.y * uniforms.camera.size.x + pixel.x;
  uint share = uniforms.surface.share.v[index];
  float values[8];
  for (uint s = 0u; s < k_samples; ++s) {
    uint leader = sharing_sample(share, s);
    values[s] = leader < s ? values[leader] : evaluate(uniforms, pixel, s);
    mask.v[index * k_samples + s] = values[s];
  }
}

void main() {
  Uniforms uniforms;
  uniforms.camera = frame.v.camera;
  uniforms.camera.samples = k_samples;
  uniforms.surface = frame.v.surface;
  uniforms.shape = frame.v.lights.v[light].shape;
  uniforms.projection = projection.v;
  uniforms.map_filter = map_filter.v;
  uniforms.bias = bias.v;
  uvec2 size = uniforms.camera.size;
  if (k_samples > 1u) {
    for (uint i = 0u; i < 4u; ++i) {
      if (all(lessThan(pixel_of_tile(i), size))) resolve_samples(uniforms, pixel_of_tile(i));
    }
    return;
  }
  // All are answered before the first is written: behind a write, compilers read all that is shared again.
  float values[4];
  for (uint i = 0u; i < 4u; ++i) values[i] = evaluate(uniforms, min(pixel_of_tile(i), size - 1u), 0u);
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 pixel = pixel_of_tile(i);
    if (all(lessThan(pixel, size))) mask.v[pixel.y * size.x + pixel.x] = values[i];
  }
}
