// A camera that flies: position and two angles, moved by what the user did in a frame.
#pragma once

#include <string>

#include "scene/scene.h"

namespace gnomon::viewer {

struct CameraInput {
  vec3 move = vec3(0.0f);     // -1 to 1: right, up, forward
  vec2 look_px = vec2(0.0f);  // of the mouse: right, down
  float wheel = 0.0f;
  bool around = false;  // turns about what is looked at, not about itself
};

// As --camera reads it.
std::string camera_text(const vec3& eye_ws, const vec3& target_ws);

class FlyCamera {
 public:
  // Stands where `camera` does; a tilted head is put upright. `scale_m`: of the scene, for the first speed.
  FlyCamera(const Camera& camera, float scale_m);

  // True when it moved or turned.
  bool update(const CameraInput& input, float seconds);
  void stand_at(const Camera& camera);
  void look_at(const vec3& target_ws);
  // Turns and keeps `distance_m` from `centre_ws`, which it looks at.
  void turn_about(const vec3& centre_ws, float distance_m, vec2 look_px);

  const vec3& eye() const { return eye_ws_; }
  vec3 forward() const;
  // Nearer than this nothing is orbited, nothing is looked at: metres.
  float closest() const { return closest_m_; }
  std::string text() const;
  float speed() const { return speed_m_s_; }

 private:
  void look_along(const vec3& forward);
  void turn(vec2 look_px);

  vec3 eye_ws_;
  float yaw_, pitch_;  // radians; 0, 0 looks along -Z, positive yaw to the right
  float speed_m_s_, closest_m_;
};

}  // namespace gnomon::viewer
