// The surface buffer as points for the reference (scene/surface_point.h), one per sample.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/surface.glsl"
#include "frame/glsl/surface_point.glsl"

layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  SurfacePoints points;
};
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  CameraData camera = frame.v.camera;
  if (any(greaterThanEqual(pixel, camera.size))) return;
  for (uint s = 0u; s < camera.samples; ++s) {
    uint index = sample_index(camera, pixel, s);
    SurfacePoint point;
    Surface surface;
    bool seen = load_surface(frame, pixel, s, surface);
    point.position_ws = seen ? surface.position_ws : vec3(0.0);
    point.geometric_normal_ws = seen ? surface.geometric_normal_ws : vec3(0.0, 1.0, 0.0);
    point.object = seen ? frame.v.scene.items.v[frame.v.surface.item.v[index]].object : 0xffffffffu;
    point.pixel = pixel.y * camera.size.x + pixel.x;
    points.v[index] = point;
  }
}
