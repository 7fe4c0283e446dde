// Which object is nearest to the light, alpha-tested.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/draw/caster_alpha.glsl"
#include "frame/casters/draw/caster_pass.glsl"

layout(constant_id = 0) const uint k_item_ids = 0;  // 1: the draw item + 1 instead
layout(location = 0) in vec2 texel;
layout(location = 1) flat in uint item_index;
layout(location = 3) flat in AlphaLookup lookup;
layout(location = 0) out uint id;

void main() {
  if (!alpha_exists(lookup, texel)) discard;
  id = (k_item_ids != 0u ? item_index : pass.scene.items.v[item_index].object) + 1u;
}
