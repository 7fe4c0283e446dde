// What a resolve must move at the least: reads depth and normal of each sample and writes its visibility.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/surface.glsl"

layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  Floats mask;
};
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  CameraData camera = frame.v.camera;
  if (any(greaterThanEqual(pixel, camera.size))) return;
  for (uint s = 0u; s < camera.samples; ++s) {
    uint index = sample_index(camera, pixel, s);
    float z = frame.v.surface.view_z.v[index];
    vec3 normal = unpack_normal(frame.v.surface.geometric_normal.v[index]);
    mask.v[index] = z > 0.0 ? abs(normal.y) : 1.0;
  }
}
