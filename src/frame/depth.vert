// Casters seen from a light: positions only, uv for alpha-tested ones.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/depth_pass.glsl"

layout(location = 0) out vec2 uv;
layout(location = 1) flat out uint item_index;

void main() {
  DrawItem item = pass.scene.items.v[gl_InstanceIndex];
  vec3 position_ws = to_world(item, pass.scene.positions.v[gl_VertexIndex]);
  uv = pass.scene.attributes.v[gl_VertexIndex].uv;
  item_index = gl_InstanceIndex;
  gl_Position = pass.view.clip_from_world * vec4(position_ws, 1.0);
}
