// Vertices of the surface pass: what the camera sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/draw_vertex.glsl"
#include "frame/glsl/octahedral.glsl"

layout(push_constant, scalar) uniform Push { FrameDataRef frame; };

layout(location = 0) out vec2 uv;
layout(location = 1) out vec3 normal_ws;
layout(location = 2) out vec4 tangent_ws;
layout(location = 3) out vec4 colour;
layout(location = 4) flat out uint item_index;

void main() {
  DrawItem item = frame.v.scene.items.v[gl_InstanceIndex];
  VertexAttributes attributes = frame.v.scene.attributes.v[gl_VertexIndex];
  vec3 position_ws = to_world(item, frame.v.scene.positions.v[gl_VertexIndex]);
  uv = attributes.uv;
  normal_ws = normal_to_world(item, unpack_normal(attributes.normal));
  // Mirroring turns the cross product of normal and tangent round.
  bool left_handed = ((attributes.tangent & 1u) != 0u) != ((item.flags & k_item_mirrored) != 0u);
  float handedness = left_handed ? -1.0 : 1.0;
  tangent_ws = vec4(direction_to_world(item, unpack_normal(attributes.tangent)), handedness);
  colour = unpackUnorm4x8(attributes.colour);
  item_index = gl_InstanceIndex;
  gl_Position = frame.v.camera.clip_from_world * vec4(position_ws, 1.0);
}
