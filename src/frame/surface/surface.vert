// Vertices of the surface pass: what the camera sees. All that a material says is looked up here: fragments, of which there are
// many more, then read nothing but textures.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "base/glsl/alpha.glsl"
#include "frame/glsl/draw_vertex.glsl"
#include "frame/glsl/octahedral.glsl"
#include "frame/glsl/texture_lookup.glsl"

layout(push_constant, scalar) uniform Push { FrameDataRef frame; };

layout(location = 0) out vec4 uv;  // of the base texture, of the normal map
layout(location = 1) out vec3 normal_ws;
layout(location = 2) out vec4 tangent_ws;
layout(location = 3) out vec3 tint;
layout(location = 4) flat out vec3 scalars;  // alpha without the texture; least alpha that exists; scale of the normal map
layout(location = 5) flat out uvec4 ids;     // item; 1: mirrored; texture_lookup() of the base texture, of the normal map

void main() {
  DrawItem item = frame.v.scene.items.v[gl_InstanceIndex];
  MaterialData material = frame.v.scene.materials.v[item.material];
  VertexAttributes attributes = frame.v.scene.attributes.v[gl_VertexIndex];
  vec3 position_ws = to_world(item, frame.v.scene.positions.v[gl_VertexIndex]);
  uv.xy = transform_uv(material.base_uv_u, material.base_uv_v, attributes.uv);
  uv.zw = transform_uv(material.normal_uv_u, material.normal_uv_v, attributes.uv);
  normal_ws = normal_to_world(item, unpack_normal(attributes.normal));
  // Mirroring turns the cross product of normal and tangent round.
  bool mirrored = (item.flags & k_item_mirrored) != 0u;
  bool left_handed = ((attributes.tangent & 1u) != 0u) != mirrored;
  float handedness = left_handed ? -1.0 : 1.0;
  tangent_ws = vec4(direction_to_world(item, unpack_normal(attributes.tangent)), handedness);
  tint = material.base_colour.rgb * unpackUnorm4x8(attributes.colour).rgb;
  scalars = vec3(material.base_colour.a, material.seen_cutoff, material.normal_scale);
  ids = uvec4(gl_InstanceIndex, mirrored ? 1u : 0u, texture_lookup(material.base_texture, material.base_sampler),
              frame.v.normal_maps != 0u ? texture_lookup(material.normal_texture, material.normal_sampler)
                                        : k_no_texture_index);
  gl_Position = frame.v.camera.clip_from_world * vec4(position_ws, 1.0);
}
