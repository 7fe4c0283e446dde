// From the world to the window's coordinates of the interface, and back: for handles that are drawn over the picture.
#pragma once

#include <optional>

#include "frame/camera_data.h"

namespace gnomon::viewer {

struct WorldRay {
  vec3 origin_ws, direction_ws;  // direction: unit
};

class ScreenSpace {
 public:
  ScreenSpace(const CameraData& camera, vec2 screen_size) : camera_(camera), size_(screen_size) {}

  // nullopt for what lies behind the camera.
  std::optional<vec2> to_screen(const vec3& point_ws) const;
  WorldRay ray_at(vec2 screen) const;
  // Length in metres that takes so many pixels at a point's distance.
  float metres(const vec3& point_ws, float pixels) const;
  const CameraData& camera() const { return camera_; }
  vec2 size() const { return size_; }

 private:
  const CameraData& camera_;
  vec2 size_;
};

// The point of a line that is nearest to the ray; nullopt where they are parallel.
std::optional<vec3> nearest_on_line(const vec3& point_ws, const vec3& direction_ws, const WorldRay& ray);
// Where the ray meets the plane, ahead of it.
std::optional<vec3> on_plane(const vec3& point_ws, const vec3& normal_ws, const WorldRay& ray);

}  // namespace gnomon::viewer
