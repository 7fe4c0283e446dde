// Which object is nearest to the light: its number + 1; 0 where there is none.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/caster_pass.glsl"

layout(location = 1) flat in uint item_index;
layout(location = 0) out uint id;

void main() { id = pass.scene.items.v[item_index].object + 1u; }
