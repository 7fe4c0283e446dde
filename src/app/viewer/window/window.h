// The window: GLFW, the keys and the mouse, the surface that pictures go to.
#pragma once

#include <string>
#include <vector>

#include "base/maths.h"
#include "gpu/device.h"

struct GLFWwindow;

namespace gnomon::viewer {

class Window {
 public:
  // Throws Error (device) where there is no display, or no Vulkan on it.
  Window(uvec2 size, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  WindowNeeds needs() const;
  VkSurfaceKHR make_surface(VkInstance instance) const;

  uvec2 size() const;  // pixels; 0 x 0 while it is minimised
  void set_title(const std::string& title);
  // How much larger than usual the user wants text and widgets, in pixels of the window.
  float interface_scale() const;
  bool closing() const;
  void close();

  // Takes what the user did since the last call; `wait` sleeps until there is something, 0.1 s at most.
  void poll(bool wait);
  // Whether the user did something that the next poll will take; to be asked when this frame's keys have been read. A pointer
  // that moves counts while a button is held.
  bool has_input();
  // Since the last poll; keys are GLFW's.
  bool pressed(int key) const;
  // Now, or for a moment since the last poll: no short press is lost in a slow frame.
  bool held(int key) const;
  bool control_held() const;
  // While it is on, the pointer is hidden and kept in place; mouse_motion says how far the mouse was moved since the last poll.
  void capture_mouse(bool on);
  vec2 mouse_motion() const { return motion_; }
  bool right_button() const;
  // Paths of the files that were dropped onto the window since the last poll.
  const std::vector<std::string>& dropped() const { return dropped_; }

 private:
  static Window& of(GLFWwindow* window);

  GLFWwindow* window_ = nullptr;
  std::vector<int> pressed_;
  std::vector<std::string> dropped_;
  vec2 mouse_ = vec2(0.0f), motion_ = vec2(0.0f);
  bool captured_ = false;
  bool input_ = false, looked_ahead_ = false;
};

}  // namespace gnomon::viewer
