#include "app/viewer/camera/fly_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {
namespace {

constexpr float k_radians_per_px = 0.2f * k_pi / 180.0f;
constexpr float k_max_pitch = 0.495f * k_pi;
constexpr float k_speed_per_notch = 1.25f;

}  // namespace

std::string camera_text(const vec3& eye_ws, const vec3& target_ws) {
  return fmt::format("{:.7g},{:.7g},{:.7g}:{:.7g},{:.7g},{:.7g}", eye_ws.x, eye_ws.y, eye_ws.z, target_ws.x, target_ws.y,
                     target_ws.z);
}

FlyCamera::FlyCamera(const Camera& camera, float scale_m)
    : speed_m_s_(std::max(0.1f * scale_m, 1e-3f)), closest_m_(std::max(1e-3f * scale_m, 1e-5f)) {
  stand_at(camera);
}

void FlyCamera::stand_at(const Camera& camera) {
  eye_ws_ = vec3(camera.world_from_view[3]);
  look_along(-glm::normalize(vec3(camera.world_from_view[2])));
}

void FlyCamera::look_at(const vec3& target_ws) {
  const vec3 arm = target_ws - eye_ws_;
  if (glm::length(arm) > closest_m_) look_along(glm::normalize(arm));
}

void FlyCamera::look_along(const vec3& forward) {
  yaw_ = std::atan2(forward.x, -forward.z);
  pitch_ = std::clamp(std::asin(std::clamp(forward.y, -1.0f, 1.0f)), -k_max_pitch, k_max_pitch);
}

void FlyCamera::turn(vec2 look_px) {
  yaw_ += look_px.x * k_radians_per_px;
  pitch_ = std::clamp(pitch_ - look_px.y * k_radians_per_px, -k_max_pitch, k_max_pitch);
}

vec3 FlyCamera::forward() const {
  return {std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_), -std::cos(pitch_) * std::cos(yaw_)};
}

bool FlyCamera::update(const CameraInput& input, float seconds) {
  speed_m_s_ = std::clamp(speed_m_s_ * std::pow(k_speed_per_notch, input.wheel), 1e-3f, 1e4f);
  if (input.move == vec3(0.0f) && input.look_px == vec2(0.0f)) return false;
  turn(input.look_px);
  const vec3 right(std::cos(yaw_), 0.0f, std::sin(yaw_));
  eye_ws_ += (right * input.move.x + vec3(0, 1, 0) * input.move.y + forward() * input.move.z) * (speed_m_s_ * seconds);
  return true;
}

void FlyCamera::turn_about(const vec3& centre_ws, float distance_m, vec2 look_px) {
  turn(look_px);
  eye_ws_ = centre_ws - std::max(distance_m, closest_m_) * forward();
}

std::string FlyCamera::text() const {
  // The target so far away that seven digits turn the view by less than a hundredth of a pixel.
  const float reach = std::max(10.0f, 0.1f * glm::length(eye_ws_));
  return camera_text(eye_ws_, eye_ws_ + reach * forward());
}

}  // namespace gnomon::viewer
