// What one sample of the surface buffer stores before packing: albedo, shading normal, and which triangle it is.
// The ids are whole numbers in floats: integer attachments may not be multisampled on every device. Exact up to 2^24.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/texture_lookup.glsl"

// As surface.vert writes them.
layout(location = 0) in vec4 uv;
layout(location = 1) in vec3 normal_ws;
layout(location = 2) in vec4 tangent_ws;
layout(location = 3) in vec3 tint;
layout(location = 4) flat in vec3 scalars;
layout(location = 5) flat in uvec4 ids;

layout(location = 0) out vec4 albedo_out;
layout(location = 1) out vec4 normal_out;
layout(location = 2) out vec2 id_out;

vec3 shading_normal(bool front) {
  vec3 n = normalize(normal_ws) * (front ? 1.0 : -1.0);
  if (ids.w == k_no_texture_index) return n;
  vec3 mapped = texture(LOOKUP_SAMPLER2D(ids.w), uv.zw).xyz * 2.0 - 1.0;
  mapped.xy *= scalars.z;
  vec3 t = tangent_ws.xyz - n * dot(n, tangent_ws.xyz);
  float t_length = length(t);
  if (!(t_length > 1e-6)) return n;
  t /= t_length;
  vec3 b = cross(n, t) * tangent_ws.w * (front ? 1.0 : -1.0);
  return normalize(t * mapped.x + b * mapped.y + n * max(mapped.z, 1e-3));
}

void main() {
  vec4 albedo = vec4(tint, scalars.x);
  if (ids.z != k_no_texture_index) albedo *= texture(LOOKUP_SAMPLER2D(ids.z), uv.xy);
  if (albedo.a < scalars.y) discard;
  albedo_out = vec4(albedo.rgb, 1.0);
  normal_out = vec4(shading_normal(gl_FrontFacing != (ids.y != 0u)), 0.0);
  id_out = vec2(float(ids.x), float(gl_PrimitiveID));
}
