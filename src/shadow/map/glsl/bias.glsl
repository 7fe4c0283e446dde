// Biases that every projection and filter shares. All are given in texels, so that they follow the map's resolution.
#ifndef GNOMON_BIAS_GLSL
#define GNOMON_BIAS_GLSL
#include "shadow/map/glsl/map_data.glsl"

#include "base/glsl/params_struct.glsl"
struct BiasParams {
#include "shadow/map/bias.params"
  uint table_end;
};
#include "base/params_undefine.h"

// Sine and tangent of the angle between normal and light.
vec2 receiver_slope(BiasParams bias, vec3 normal_ws, vec3 to_light) {
  float cosine = clamp(dot(normal_ws, to_light), 1e-4, 1.0);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  return vec2(sine, min(sine / cosine, bias.max_slope));
}

// Normal offset (Holbert 2011): grows with the sine, because a receiver that faces the light needs none.
vec3 offset_position(BiasParams bias, vec3 position_ws, vec3 normal_ws, float slope_sine, float texel_m) {
  return position_ws + normal_ws * (bias.normal_offset * texel_m * slope_sine);
}

float depth_bias_m(BiasParams bias, float slope_tangent, float texel_m) {
  return (bias.constant + bias.slope * slope_tangent) * texel_m;
}

// Receiver plane: d depth / d uv of the plane through the point with the given normal, for a view whose clip space is affine
// (orthographic): solve  n . (world displacement) = 0  for displacements along u and v. (Isidoro 2006, in closed form.)
vec2 plane_depth_gradient(mat4 clip_from_world, vec3 normal_ws) {
  // Rows of the affine map are, up to scale, the world directions of u, v and depth; they are orthogonal.
  vec3 row_u = vec3(clip_from_world[0].x, clip_from_world[1].x, clip_from_world[2].x);
  vec3 row_v = vec3(clip_from_world[0].y, clip_from_world[1].y, clip_from_world[2].y);
  vec3 row_z = vec3(clip_from_world[0].z, clip_from_world[1].z, clip_from_world[2].z);
  // World displacement per unit of clip u, v, depth.
  vec3 along_u = row_u / dot(row_u, row_u), along_v = row_v / dot(row_v, row_v), along_z = row_z / dot(row_z, row_z);
  float facing = dot(normal_ws, along_z);
  if (abs(facing) < 1e-8 * length(along_z)) return vec2(0.0);
  // uv = clip * 0.5 + 0.5: one unit of uv is two of clip.
  return -2.0 * vec2(dot(normal_ws, along_u), dot(normal_ws, along_v)) / facing;
}

#endif
