#include "app/viewer/camera/camera_rig.h"

#include <cmath>

namespace gnomon::viewer {
namespace {

constexpr float k_keys_px_s = 300.0f;     // turning by keys, as if the mouse was moved so fast
constexpr float k_distance_per_s = 2.0f;  // moving by keys: the distance is halved or doubled
constexpr float k_distance_per_notch = 0.87f;

}  // namespace

bool CameraRig::update(const CameraInput& input, float seconds) {
  const bool around = orbits_ || input.around;
  if (!around) {
    around_ = false;
    return camera_.update(input, seconds);
  }
  // The centre is what is looked at; one that lies elsewhere is of a walk before.
  if (!around_ && !orbits_ && !looks_at_centre()) centre_ws_.reset();
  around_ = true;
  if (!centre_ws_) centre_ws_ = ahead();
  return orbit(input, seconds);
}

bool CameraRig::orbit(const CameraInput& input, float seconds) {
  if (input.move == vec3(0.0f) && input.look_px == vec2(0.0f) && input.wheel == 0.0f) return false;
  float distance = glm::length(*centre_ws_ - camera_.eye());
  distance *= std::pow(k_distance_per_s, -input.move.z * seconds) * std::pow(k_distance_per_notch, input.wheel);
  camera_.look_at(*centre_ws_);
  camera_.turn_about(*centre_ws_, distance, input.look_px + vec2(-input.move.x, input.move.y) * (k_keys_px_s * seconds));
  return true;
}

bool CameraRig::looks_at_centre() const {
  if (!centre_ws_) return false;
  const vec3 arm = *centre_ws_ - camera_.eye();
  return glm::dot(arm, camera_.forward()) > 0.98f * glm::length(arm);
}

void CameraRig::stand_at(const Camera& camera) {
  const float distance = centre_ws_ ? glm::length(*centre_ws_ - camera_.eye()) : 0.5f * scale_m_;
  camera_.stand_at(camera);
  if (!looks_at_centre()) centre_ws_ = camera_.eye() + distance * camera_.forward();
}

void CameraRig::focus(const vec3& point_ws) {
  centre_ws_ = point_ws;
  camera_.look_at(point_ws);
}

void CameraRig::set_orbits(bool on) {
  orbits_ = on;
  if (!on) return;
  if (!centre_ws_) centre_ws_ = ahead();
}

}  // namespace gnomon::viewer
