// From a scene's camera to what shaders read.
#include "frame/camera_data.h"

namespace gnomon {

CameraData camera_data(const Camera& camera, uvec2 size, uint32_t samples, vec2 subpixel) {
  const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
  const mat4& pose = camera.world_from_view;
  CameraData data = {};
  data.eye_ws = vec3(pose[3]);
  const vec3 right = glm::normalize(vec3(pose[0])), up = glm::normalize(vec3(pose[1]));
  data.forward_ws = -glm::normalize(vec3(pose[2]));
  data.near_m = camera.near;
  data.far_m = camera.far;
  data.size = size;
  data.samples = samples;
  data.subpixel = subpixel;
  data.orthographic = camera.orthographic;

  mat4 clip_from_view(0.0f);
  if (camera.orthographic) {
    const float depth = camera.far - camera.near;
    data.right_ws = right * (camera.half_height * aspect);
    data.up_ws = up * camera.half_height;
    clip_from_view[0][0] = 1.0f / (camera.half_height * aspect);
    clip_from_view[1][1] = -1.0f / camera.half_height;
    clip_from_view[2][2] = 1.0f / depth;
    clip_from_view[3][2] = camera.far / depth;
    clip_from_view[3][3] = 1.0f;
  } else {
    const float slope = std::tan(0.5f * camera.vertical_fov);
    data.right_ws = right * (slope * aspect);
    data.up_ws = up * slope;
    clip_from_view[0][0] = 1.0f / (slope * aspect);
    clip_from_view[1][1] = -1.0f / slope;
    clip_from_view[3][2] = camera.near;
    clip_from_view[2][3] = -1.0f;
  }
  mat4 rigid(vec4(right, 0.0f), vec4(up, 0.0f), vec4(-data.forward_ws, 0.0f), vec4(data.eye_ws, 1.0f));
  // The rasteriser samples where it always does: the picture moves the other way.
  const vec2 shift = -2.0f * subpixel / vec2(size);
  const mat4 shifted = glm::translate(mat4(1.0f), vec3(shift, 0.0f));
  data.clip_from_world = shifted * clip_from_view * glm::inverse(rigid);
  return data;
}

std::array<vec3, 8> slice_corners(const CameraData& camera, float from_m, float to_m) {
  std::array<vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const vec3 sideways = camera.right_ws * (i & 1 ? 1.0f : -1.0f) + camera.up_ws * (i & 2 ? 1.0f : -1.0f);
    const float distance = i & 4 ? to_m : from_m;
    corners[static_cast<size_t>(i)] =
        camera.eye_ws + camera.forward_ws * distance + sideways * (camera.orthographic ? 1.0f : distance);
  }
  return corners;
}

}  // namespace gnomon
