#include "app/viewer/fly_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {
namespace {

constexpr float k_radians_per_px = 0.2f * k_pi / 180.0f;
constexpr float k_max_pitch = 0.495f * k_pi;
constexpr float k_speed_per_notch = 1.25f;

}  // namespace

FlyCamera::FlyCamera(const Camera& camera, float scale_m) : eye_ws_(camera.world_from_view[3]) {
  const vec3 forward = -glm::normalize(vec3(camera.world_from_view[2]));
  yaw_ = std::atan2(forward.x, -forward.z);
  pitch_ = std::clamp(std::asin(std::clamp(forward.y, -1.0f, 1.0f)), -k_max_pitch, k_max_pitch);
  speed_m_s_ = std::max(0.1f * scale_m, 1e-3f);
}

vec3 FlyCamera::forward() const {
  return {std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_), -std::cos(pitch_) * std::cos(yaw_)};
}

bool FlyCamera::update(const CameraInput& input, float seconds) {
  speed_m_s_ = std::clamp(speed_m_s_ * std::pow(k_speed_per_notch, input.wheel), 1e-3f, 1e4f);
  if (input.move == vec3(0.0f) && input.look_px == vec2(0.0f)) return false;
  yaw_ += input.look_px.x * k_radians_per_px;
  pitch_ = std::clamp(pitch_ - input.look_px.y * k_radians_per_px, -k_max_pitch, k_max_pitch);
  const vec3 right(std::cos(yaw_), 0.0f, std::sin(yaw_));
  eye_ws_ += (right * input.move.x + vec3(0, 1, 0) * input.move.y + forward() * input.move.z) * (speed_m_s_ * seconds);
  return true;
}

std::string FlyCamera::text() const {
  // The target ten metres away, so that five digits behind the point turn the view by less than a hundredth of a pixel.
  const vec3 target = eye_ws_ + 10.0f * forward();
  return fmt::format("{:.5f},{:.5f},{:.5f}:{:.5f},{:.5f},{:.5f}", eye_ws_.x, eye_ws_.y, eye_ws_.z, target.x, target.y, target.z);
}

}  // namespace gnomon::viewer
