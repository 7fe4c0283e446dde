// Push constants of a pass that draws casters into layers of a map.
#ifndef GNOMON_CASTER_PASS_GLSL
#define GNOMON_CASTER_PASS_GLSL
#include "frame/casters/caster_data.glsl"
#include "frame/glsl/draw_vertex.glsl"

layout(push_constant, scalar) uniform Push {
  uint64_t views;  // of the scope's first layer
  uint stride, layers;
  SceneData scene;
} pass;

uint item_of(uint instance) { return instance & ((1u << k_instance_item_bits) - 1u); }
uint tag_of(uint instance) { return instance >> k_instance_item_bits; }
vec4 clip_in_layer(uint layer, vec3 position_ws) {
  return light_clip(light_view(pass.views, pass.stride, layer).v, position_ws);
}

#endif
