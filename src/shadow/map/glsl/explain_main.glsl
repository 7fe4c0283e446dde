// The kernel of overlays and picks. With GNOMON_EXPLAIN_MAP the includer has defined ProjectionParams, project() and what
// map_sample.glsl needs.
#include "shadow/map/glsl/explain_data.glsl"
#ifdef GNOMON_EXPLAIN_MAP
#include "shadow/map/glsl/explain_map.glsl"
#endif

layout(buffer_reference, scalar) writeonly buffer PickRecordRef { PickRecord v; };

layout(constant_id = 0) const uint k_samples = 1;
layout(push_constant, scalar) uniform Push { ExplainArguments arguments; };
layout(local_size_x = 8, local_size_y = 8) in;

FrameData data;
CameraData camera;
LightShape shape;

uint item_of(uvec2 pixel, uint s) { return data.surface.item.v[sample_index(camera, pixel, s)]; }

uint flag_of(uvec2 pixel, uint s, Surface surface) {
  vec3 to_light = direction_to_light(shape, surface.position_ws);
  if (dot(surface.geometric_normal_ws, to_light) <= k_grazing_cosine) return k_flag_away;
  if (!receives_light(shape, surface.position_ws, surface.geometric_normal_ws)) return k_flag_beyond;
#ifdef GNOMON_EXPLAIN_MAP
  uint layers[2];
  float weights[2];
  if (project(ShadowViews(arguments.views), ProjectionParamsRef(arguments.projection).v, surface.position_ws, layers,
              weights) == 0u) {
    return k_flag_outside;
  }
#endif
  return (data.scene.items.v[item_of(pixel, s)].flags & k_item_casts) != 0u ? k_flag_caster : k_flag_receiver;
}

// Colour and how much of it.
vec4 overlay_of(uvec2 pixel, uint s, Surface surface) {
  if (arguments.overlay == k_overlay_flags) return vec4(flag_colour(flag_of(pixel, s, surface)), 1.0);
  if (arguments.overlay == k_overlay_overdraw) {
    return vec4(ramp_colour(overdraw_place(texelFetch(images_2d[arguments.overdraw_image], ivec2(pixel), 0).x)), 1.0);
  }
#ifdef GNOMON_EXPLAIN_MAP
  ShadowViews views = ShadowViews(arguments.views);
  uint layers[2];
  float weights[2];
  uint count = project(views, ProjectionParamsRef(arguments.projection).v, surface.position_ws, layers, weights);
  Receiver receiver = receiver_of(camera, shape, pixel, s, surface);
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < count; ++i) {
    MapSample at = sample_of(views, layers[i], BiasParamsRef(arguments.bias).v, Floats(arguments.radius).v[0], receiver);
    vec4 colour = overlay_of_layer(at, arguments.overlay);
    sum += weights[i] * vec4(colour.rgb * colour.a, colour.a);
  }
  return sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a) : vec4(0.0);
#else
  return vec4(0.0);
#endif
}

void draw_pixel(uvec2 pixel) {
  vec4 sum = vec4(0.0);
  for (uint s = 0u; s < k_samples; ++s) {
    Surface surface;
    if (!load_surface(camera, data.surface, pixel, s, surface)) continue;
    vec4 colour = overlay_of(pixel, s, surface);
    sum += vec4(colour.rgb * colour.a, colour.a) / float(k_samples);
  }
  if (sum.a <= 0.0) return;
  Uints display = Uints(arguments.output_words);
  uint index = pixel.y * camera.size.x + pixel.x;
  vec4 shown = unpackUnorm4x8(display.v[index]);
  shown.rgb = shown.rgb * (1.0 - arguments.opacity * sum.a) + arguments.opacity * sum.rgb;
  display.v[index] = packUnorm4x8(shown);
}

void write_pick() {
  PickRecordRef record = PickRecordRef(arguments.output_words);
  uvec2 pixel = arguments.pixel;
  Surface surface;
  bool seen = load_surface(camera, data.surface, pixel, 0u, surface);
  record.v.seen = seen ? 1u : 0u;
  record.v.count = 0u;
  if (!seen) return;
  uint item = item_of(pixel, 0u);
  vec3 to_light = direction_to_light(shape, surface.position_ws);
  record.v.receives = receives_light(shape, surface.position_ws, surface.geometric_normal_ws) ? 1u : 0u;
  record.v.item = item;
  record.v.object = data.scene.items.v[item].object;
  record.v.casts = (data.scene.items.v[item].flags & k_item_casts) != 0u ? 1u : 0u;
  record.v.facing = dot(surface.geometric_normal_ws, to_light);
  record.v.answer = Floats(arguments.mask).v[sample_index(camera, pixel, 0u)];
  record.v.view_depth = dot(camera.forward_ws, surface.position_ws - camera.eye_ws);
  record.v.eye_distance = surface.eye_distance;
  record.v.position_ws = surface.position_ws;
  record.v.normal_ws = surface.geometric_normal_ws;
  record.v.last_split = 0.0;
  record.v.radius = 0.0;
#ifdef GNOMON_EXPLAIN_MAP
  ShadowViews views = ShadowViews(arguments.views);
  float radius = Floats(arguments.radius).v[0];
  record.v.radius = radius;
  if (views.map.layers > 0u) record.v.last_split = views.v[views.map.layers - 1u].interval_m.y;
  uint layers[2];
  float weights[2];
  uint count = project(views, ProjectionParamsRef(arguments.projection).v, surface.position_ws, layers, weights);
  record.v.count = count;
  Receiver receiver = receiver_of(camera, shape, pixel, 0u, surface);
  for (uint i = 0u; i < count; ++i) {
    record.v.layers[i] = pick_layer(arguments, views, layers[i], weights[i], BiasParamsRef(arguments.bias).v, radius, receiver);
  }
#endif
}

void main() {
  data = FrameDataRef(arguments.frame).v;
  camera = data.camera;
  camera.samples = k_samples;
  shape = data.lights.v[arguments.light].shape;
  if (arguments.overlay == k_overlay_none) {
    if (gl_GlobalInvocationID.xy == uvec2(0u)) write_pick();
    return;
  }
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 pixel = pixel_of_tile(i);
    if (all(lessThan(pixel, camera.size))) draw_pixel(pixel);
  }
}
