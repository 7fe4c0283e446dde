// What moves the camera: it flies, or it orbits a point.
#pragma once

#include <optional>

#include "app/viewer/camera/fly_camera.h"

namespace gnomon::viewer {

class CameraRig {
 public:
  CameraRig(const Camera& camera, float scale_m) : camera_(camera, scale_m), scale_m_(scale_m) {}

  // True when the camera moved or turned. In an orbit the mouse, left, right, up and down go around the centre, forward, back
  // and the wheel toward and away from it.
  bool update(const CameraInput& input, float seconds);
  // Goes on from where `camera` stands, after it was placed by something else.
  void stand_at(const Camera& camera);
  // Looks at the point, and orbits it.
  void focus(const vec3& point_ws);

  bool orbits() const { return orbits_; }
  // About the point that was focused, else about one ahead.
  void set_orbits(bool on);
  const std::optional<vec3>& centre() const { return centre_ws_; }

  const FlyCamera& camera() const { return camera_; }

 private:
  bool orbit(const CameraInput& input, float seconds);
  bool looks_at_centre() const;
  vec3 ahead() const { return camera_.eye() + 0.5f * scale_m_ * camera_.forward(); }

  FlyCamera camera_;
  float scale_m_;                         // of the scene
  bool orbits_ = false, around_ = false;  // around_: in the last frame, at least
  std::optional<vec3> centre_ws_;
};

}  // namespace gnomon::viewer
