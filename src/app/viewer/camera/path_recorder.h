// A walk, and what the sun does meanwhile, become paths.
#pragma once

#include <optional>

#include "lab/view/path_file.h"

namespace gnomon::viewer {

// What can be recorded at one moment.
struct Moment {
  CameraPose camera;
  std::optional<SunState> sun;  // where there is one
};

class PathRecorder {
 public:
  void start(const Moment& moment);
  // Every frame while it records. Keys are a tenth of a second apart at least.
  void add(double seconds, const Moment& moment);
  // A path of what moved, both with the same times; nullopt where nothing did. A sun that came later, or is gone meanwhile,
  // stays where it was first or last.
  std::optional<Recording> stop(const std::string& name);

  bool records() const { return records_; }
  double time_s() const { return time_s_; }

 private:
  struct Key {
    double time_s;
    Moment moment;
  };
  std::vector<Key> keys_;
  Moment last_ = {};
  double time_s_ = 0.0;
  bool records_ = false;
};

}  // namespace gnomon::viewer
