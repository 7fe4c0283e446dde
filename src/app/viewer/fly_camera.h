// A camera that flies: position and two angles, moved by what the user did in a frame.
#pragma once

#include <string>

#include "scene/scene.h"

namespace gnomon::viewer {

struct CameraInput {
  vec3 move = vec3(0.0f);  // -1 to 1: right, up, forward
  vec2 look_px = vec2(0.0f);  // of the mouse: right, down
  float wheel = 0.0f;
};

class FlyCamera {
 public:
  // Stands where `camera` does; a tilted head is put upright. `scale_m`: of the scene, for the first speed.
  FlyCamera(const Camera& camera, float scale_m);

  // True when it moved or turned.
  bool update(const CameraInput& input, float seconds);
  // As --camera reads it.
  std::string text() const;
  float speed() const { return speed_m_s_; }

 private:
  vec3 forward() const;

  vec3 eye_ws_;
  float yaw_, pitch_;  // radians; 0, 0 looks along -Z, positive yaw to the right
  float speed_m_s_;
};

}  // namespace gnomon::viewer
