// Copies a triangle into each layer that its draw touches.
#include "frame/casters/draw/caster_pass.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 24) out;  // three for each of k_max_layers

layout(location = 2) flat in uint layer_mask[];
#ifdef CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_alpha.glsl"
layout(location = 0) in vec2 texel_in[];
layout(location = 1) flat in uint item_in[];
layout(location = 3) flat in AlphaLookup lookup_in[];
layout(location = 0) out vec2 texel;
layout(location = 1) flat out uint item_index;
layout(location = 3) flat out AlphaLookup lookup;
#endif

void main() {
  for (uint layer = 0u; layer < pass.layers; ++layer) {
    if ((layer_mask[0] & (1u << layer)) == 0u) continue;
    for (int i = 0; i < 3; ++i) {
      gl_Layer = int(layer);
      gl_Position = clip_in_layer(layer, gl_in[i].gl_Position.xyz);
#ifdef CASTER_ATTRIBUTES
      texel = texel_in[i];
      item_index = item_in[i];
      lookup = lookup_in[i];
#endif
      EmitVertex();
    }
    EndPrimitive();
  }
}
