// A texel of a paraboloid view against one triangle. The including file says CASTER_MASKED, CASTER_ID.
#include "frame/casters/draw/caster_pass.glsl"
#ifdef CASTER_MASKED
#include "frame/casters/draw/caster_alpha.glsl"
#endif

layout(location = 0) flat in vec2 disc_of_texel;
layout(location = 1) flat in uint item_index;
layout(location = 2) flat in vec3 corner_a;
layout(location = 3) flat in vec3 corner_b;
layout(location = 4) flat in vec3 corner_c;
#ifdef CASTER_MASKED
layout(location = 5) flat in vec2 texel_a;
layout(location = 6) flat in vec2 texel_b;
layout(location = 7) flat in vec2 texel_c;
layout(location = 9) flat in AlphaLookup lookup;
#endif
layout(location = 8) flat in vec2 depths;
#ifdef CASTER_ID
layout(location = 0) out uint id;
#endif

// Volume of a, b and the ray. Exactly the opposite for b, a (no fused multiply-add), so that no ray passes between two
// triangles that share an edge.
float beside(vec3 a, vec3 b, vec3 ray) {
  precise float x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
  precise float volume = (x * ray.x + y * ray.y) + z * ray.z;
  return volume;
}

void main() {
  // tan(angle / 2) along x and y. From the texel alone, not interpolated: the same for both triangles of an edge.
  vec2 disc = gl_FragCoord.xy * disc_of_texel.x + disc_of_texel.y;
  vec3 ray = vec3(2.0 * disc, 1.0 - dot(disc, disc)) / (1.0 + dot(disc, disc));
  vec3 weight = vec3(beside(corner_b, corner_c, ray), beside(corner_c, corner_a, ray), beside(corner_a, corner_b, ray));
  vec3 normal = cross(corner_b - corner_a, corner_c - corner_a);
  float facing = dot(normal, ray);
  if (facing < 0.0) weight = -weight;
  float distance_m = dot(normal, corner_a) / facing;
  // Written so that a NaN of a flattened triangle is left out.
  if (!(all(greaterThanEqual(weight, vec3(0.0))) && distance_m > depths.x && distance_m < depths.y)) discard;
#ifdef CASTER_MASKED
  vec2 texel = (texel_a * weight.x + texel_b * weight.y + texel_c * weight.z) / (weight.x + weight.y + weight.z);
  if (!alpha_exists(lookup, texel)) discard;
#endif
#ifdef CASTER_ID
  id = pass.scene.items.v[item_index].object + 1u;
#endif
  gl_FragDepth = (distance_m - depths.x) / (depths.y - depths.x);
}
