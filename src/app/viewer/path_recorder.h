// A walk becomes a camera path.
#pragma once

#include <optional>

#include "scene/path.h"

namespace gnomon::viewer {

class PathRecorder {
 public:
  void start(const CameraPose& pose);
  // Every frame while it records. Keys are a tenth of a second apart at least.
  void add(double seconds, const CameraPose& pose);
  // nullopt where the camera has not moved.
  std::optional<CameraPath> stop(const std::string& name);

  bool records() const { return records_; }
  double time_s() const { return time_s_; }

 private:
  std::vector<CameraKey> keys_;
  CameraPose last_ = {};
  double time_s_ = 0.0;
  bool records_ = false;
};

}  // namespace gnomon::viewer
