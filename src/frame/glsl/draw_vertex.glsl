// Vertex pulling: the item is the first instance of its draw, the vertex index includes the item's first vertex.
#ifndef GNOMON_DRAW_VERTEX_GLSL
#define GNOMON_DRAW_VERTEX_GLSL
#include "frame/glsl/frame_data.glsl"

vec3 to_world(DrawItem item, vec3 position) {
  vec4 p = vec4(position, 1.0);
  return vec3(dot(item.world_from_object_x, p), dot(item.world_from_object_y, p), dot(item.world_from_object_z, p));
}
vec3 direction_to_world(DrawItem item, vec3 d) {
  return vec3(dot(item.world_from_object_x.xyz, d), dot(item.world_from_object_y.xyz, d), dot(item.world_from_object_z.xyz, d));
}
// The cofactor matrix carries normals through any linear map, mirrored ones included (no inverse needed).
vec3 normal_to_world(DrawItem item, vec3 n) {
  vec3 x = item.world_from_object_x.xyz, y = item.world_from_object_y.xyz, z = item.world_from_object_z.xyz;
  vec3 result = vec3(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n));
  return (item.flags & k_item_mirrored) != 0u ? -result : result;
}

#endif
