// A clip: every frame that is drawn, as numbered pictures in a folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/viewer/window/background.h"
#include "base/image.h"

namespace gnomon::viewer {

// The first of "BASE_0000", "BASE_0001", ... that is free, with an extension or none.
std::filesystem::path free_name(const std::string& base, const std::string& extension = "");

class Clip {
 public:
  explicit Clip(Background& background) : background_(background) {}

  // Into a new folder "BASE_0000"; `seconds` 0: until stop(). Throws Error where the folder cannot be made.
  void start(const std::string& base, float seconds);
  void stop();
  bool running() const { return running_; }
  // Takes a frame while it runs.
  void add(Image8 picture);

  const std::filesystem::path& folder() const { return folder_; }
  uint32_t count() const { return count_; }
  double seconds() const;  // since start, or as long as it was

 private:
  Background& background_;
  std::filesystem::path folder_;
  bool running_ = false;
  float wanted_s_ = 0.0f;
  double lasted_s_ = 0.0;
  uint32_t count_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace gnomon::viewer
