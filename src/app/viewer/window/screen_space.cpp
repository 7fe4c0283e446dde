#include "app/viewer/window/screen_space.h"

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {

std::optional<vec2> ScreenSpace::to_screen(const vec3& point_ws) const {
  const vec4 clip = camera_.clip_from_world * vec4(point_ws, 1.0f);
  if (clip.w < 1e-6f) return std::nullopt;
  return (vec2(clip) / clip.w * 0.5f + 0.5f) * size_;
}

WorldRay ScreenSpace::ray_at(vec2 screen) const {
  const vec2 ndc = 2.0f * screen / size_ - 1.0f;
  const vec3 sideways = ndc.x * camera_.right_ws - ndc.y * camera_.up_ws;
  if (camera_.orthographic) return {camera_.eye_ws + sideways, camera_.forward_ws};
  return {camera_.eye_ws, glm::normalize(camera_.forward_ws + sideways)};
}

float ScreenSpace::metres(const vec3& point_ws, float pixels) const {
  const float depth =
      camera_.orthographic ? 1.0f : std::max(glm::dot(point_ws - camera_.eye_ws, camera_.forward_ws), camera_.near_m);
  return 2.0f * glm::length(camera_.up_ws) * depth * pixels / size_.y;
}

std::optional<vec3> nearest_on_line(const vec3& point_ws, const vec3& direction_ws, const WorldRay& ray) {
  const float across = glm::dot(direction_ws, ray.direction_ws), sine2 = 1.0f - across * across;
  if (sine2 < 1e-4f) return std::nullopt;
  const vec3 arm = ray.origin_ws - point_ws;
  return point_ws + direction_ws * ((glm::dot(arm, direction_ws) - across * glm::dot(arm, ray.direction_ws)) / sine2);
}

std::optional<vec3> on_plane(const vec3& point_ws, const vec3& normal_ws, const WorldRay& ray) {
  const float cosine = glm::dot(normal_ws, ray.direction_ws);
  if (std::abs(cosine) < 1e-4f) return std::nullopt;
  const float distance = glm::dot(point_ws - ray.origin_ws, normal_ws) / cosine;
  return distance > 0.0f ? std::optional(ray.origin_ws + distance * ray.direction_ws) : std::nullopt;
}

}  // namespace gnomon::viewer
