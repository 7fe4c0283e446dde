// How far a pixel reaches on the surface that it sees.
#ifndef GNOMON_PIXEL_FOOTPRINT_GLSL
#define GNOMON_PIXEL_FOOTPRINT_GLSL
#include "frame/glsl/surface.glsl"

// Where the ray through another pixel meets the receiver's plane, from the receiver; zero where it does not, or almost.
vec3 to_neighbour(CameraData camera, ivec2 pixel, uint s, Surface surface) {
  vec3 origin, direction;
  view_ray(camera, uvec2(pixel), s, origin, direction);
  float facing = dot(direction, surface.geometric_normal_ws);
  if (abs(facing) < 1e-3 * length(direction)) return vec3(0.0);
  return origin + direction * (dot(surface.position_ws - origin, surface.geometric_normal_ws) / facing) - surface.position_ws;
}

#endif
