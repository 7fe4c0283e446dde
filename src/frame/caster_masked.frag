// Alpha-tested casters: the texture at mip 0, bilinear, as the reference looks it up. A texel of the map is then the same point
// sample of the caster that a ray through it would be.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/alpha_test.glsl"
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/caster_pass.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) flat in uint item_index;

void main() {
  if (!alpha_exists(pass.scene.materials.v[pass.scene.items.v[item_index].material], uv)) discard;
}
