// Which object is nearest to the light, alpha-tested.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/alpha_test.glsl"
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/caster_pass.glsl"

layout(constant_id = 0) const uint k_item_ids = 0;  // 1: the draw item + 1 instead
layout(location = 0) in vec2 uv;
layout(location = 1) flat in uint item_index;
layout(location = 0) out uint id;

void main() {
  DrawItem item = pass.scene.items.v[item_index];
  if (!alpha_exists(pass.scene.materials.v[item.material], uv)) discard;
  id = (k_item_ids != 0u ? item_index : item.object) + 1u;
}
