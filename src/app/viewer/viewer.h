// The loop: input, panels, frame, window.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/viewer/canvas.h"
#include "app/viewer/fly_camera.h"
#include "app/viewer/interface.h"
#include "app/viewer/panels.h"
#include "app/viewer/swapchain.h"

namespace gnomon::viewer {

struct ViewerOptions {
  float scale = 1.0f;                // size of the picture, relative to the window's
  uint32_t frames = 0;               // ends after so many; 0: when the user closes the window
  std::filesystem::path screenshot;  // the last frame with the interface
};

class Viewer {
 public:
  Viewer(Window& window, Device& device, ViewState state, const ViewerOptions& options);
  // Until the window is closed. Throws Interrupted.
  void run();

 private:
  void draw();
  void handle_keys();
  void move_camera(ViewState& state, float seconds);
  void apply(const ViewState& next);
  uvec2 wanted_size() const;
  void follow_size(float seconds);
  void take_screenshot();

  Window& window_;
  Device& device_;
  ViewerOptions options_;
  ViewState state_;
  std::unique_ptr<Session> session_;
  TechniqueSet techniques_;
  Interface interface_;
  Canvas canvas_;
  Swapchain swapchain_;
  Panels panels_;
  FlyCamera camera_;
  Timings timings_;
  Wishes wishes_;
  std::unique_ptr<Recorder> recorder_;
  bool recorder_separates_ = false;
  std::string message_;
  float size_waits_s_ = 0.0f;
  std::chrono::steady_clock::time_point last_frame_;
};

}  // namespace gnomon::viewer
