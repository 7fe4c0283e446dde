// Opaque casters seen from a light: nothing but positions.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/depth_pass.glsl"

void main() {
  DrawItem item = pass.scene.items.v[gl_InstanceIndex];
  gl_Position = pass.view.clip_from_world * vec4(to_world(item, pass.scene.positions.v[gl_VertexIndex]), 1.0);
}
