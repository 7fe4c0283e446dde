// What one sample of the surface buffer stores before packing: albedo, shading normal, and which triangle it is.
// The ids are whole numbers in floats: integer attachments may not be multisampled on every device. Exact up to 2^24.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/frame_data.glsl"
#include "base/glsl/alpha.glsl"

layout(push_constant, scalar) uniform Push { FrameDataRef frame; };

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 normal_ws;
layout(location = 2) in vec4 tangent_ws;
layout(location = 3) in vec4 colour;
layout(location = 4) flat in uint item_index;

layout(location = 0) out vec4 albedo_out;
layout(location = 1) out vec4 normal_out;
layout(location = 2) out vec2 id_out;

vec4 sample_material(uint image, uint wrap, vec2 at) {
  return texture(sampler2D(material_textures[nonuniformEXT(image)], samplers[nonuniformEXT(wrap)]), at);
}

vec3 shading_normal(MaterialData material, bool front) {
  vec3 n = normalize(normal_ws) * (front ? 1.0 : -1.0);
  if (frame.v.normal_maps == 0u || material.normal_texture == k_no_texture_index) return n;
  vec2 at = transform_uv(material.normal_uv_u, material.normal_uv_v, uv);
  vec3 mapped = sample_material(material.normal_texture, material.normal_sampler, at).xyz * 2.0 - 1.0;
  mapped.xy *= material.normal_scale;
  vec3 t = tangent_ws.xyz - n * dot(n, tangent_ws.xyz);
  float t_length = length(t);
  if (!(t_length > 1e-6)) return n;
  t /= t_length;
  vec3 b = cross(n, t) * tangent_ws.w * (front ? 1.0 : -1.0);
  return normalize(t * mapped.x + b * mapped.y + n * max(mapped.z, 1e-3));
}

void main() {
  DrawItem item = frame.v.scene.items.v[item_index];
  MaterialData material = frame.v.scene.materials.v[item.material];
  vec4 albedo = material.base_colour * vec4(colour.rgb, 1.0);
  if (material.base_texture != k_no_texture_index) {
    vec2 at = transform_uv(material.base_uv_u, material.base_uv_v, uv);
    albedo *= sample_material(material.base_texture, material.base_sampler, at);
  }
  if (material.masked != 0u && albedo.a < material.alpha_cutoff) discard;
  albedo_out = vec4(albedo.rgb, 1.0);
  normal_out = vec4(shading_normal(material, gl_FrontFacing != ((item.flags & k_item_mirrored) != 0u)), 0.0);
  id_out = vec2(float(item_index), float(gl_PrimitiveID));
}
