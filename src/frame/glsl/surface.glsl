// Reading the surface buffer: what every technique sees of a visible sample.
#ifndef GNOMON_SURFACE_GLSL
#define GNOMON_SURFACE_GLSL
#include "frame/glsl/frame_data.glsl"
#include "frame/glsl/octahedral.glsl"
#include "frame/surface/sample_positions.glsl"

struct Surface {
  vec3 position_ws;
  vec3 geometric_normal_ws;  // unit, turned toward the viewer
  float eye_distance;        // metres
};

uint sample_index(CameraData camera, uvec2 pixel, uint s) { return (pixel.y * camera.size.x + pixel.x) * camera.samples + s; }

// The ray through a sample, not normalised: a point at view depth z lies at origin + z * direction.
void view_ray(CameraData camera, uvec2 pixel, uint s, out vec3 origin, out vec3 direction) {
  vec2 at = vec2(pixel) + sample_position(s, camera.samples) + camera.subpixel;
  vec2 ndc = at / vec2(camera.size) * 2.0 - 1.0;
  vec3 sideways = ndc.x * camera.right_ws - ndc.y * camera.up_ws;
  origin = camera.orthographic != 0u ? camera.eye_ws + sideways : camera.eye_ws;
  direction = camera.orthographic != 0u ? camera.forward_ws : camera.forward_ws + sideways;
}

// False where the camera sees the sky. `camera` and `data` are the frame's: a kernel that loads several samples reads them
// once.
bool load_surface(CameraData camera, SurfaceData data, uvec2 pixel, uint s, out Surface surface) {
  uint index = sample_index(camera, pixel, s);
  float z = data.view_z.v[index];
  if (z <= 0.0) return false;
  vec3 origin, direction;
  view_ray(camera, pixel, s, origin, direction);
  surface.position_ws = origin + z * direction;
  surface.geometric_normal_ws = unpack_normal(data.geometric_normal.v[index]);
  surface.eye_distance = length(surface.position_ws - camera.eye_ws);
  return true;
}
bool load_surface(FrameDataRef frame, uvec2 pixel, uint s, out Surface surface) {
  return load_surface(frame.v.camera, frame.v.surface, pixel, s, surface);
}

// The first sample of the pixel whose answer sample `s` shares (itself where the two lie on different surfaces).
uint sharing_sample(uint share, uint s) { return (share >> (4u * s)) & 15u; }

#endif
