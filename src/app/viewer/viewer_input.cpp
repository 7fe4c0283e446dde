// What keys and the mouse do beside the panels.
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/viewer/viewer.h"

namespace gnomon::viewer {

void Viewer::handle_keys() {
  if (interface_.takes_keys()) return;
  if (window_.pressed(GLFW_KEY_ESCAPE)) interface_.close_popup();
  if (window_.pressed(GLFW_KEY_F12)) wishes_.screenshot = true;
  if (window_.pressed(GLFW_KEY_F1)) wishes_.interface = !wishes_.interface;
  if (window_.control_held()) {
    if (window_.pressed(GLFW_KEY_Q)) window_.close();
    return;
  }
  if (window_.pressed(GLFW_KEY_B)) sides_.flip();
  if (window_.pressed(GLFW_KEY_X)) sides_.toggle_error();
}

void Viewer::move_camera(ViewState& state, float seconds) {
  CameraInput input;
  if (!interface_.takes_keys() && !window_.control_held()) {
    const auto axis = [&](std::initializer_list<int> forward, std::initializer_list<int> back) {
      const auto held = [&](int key) { return window_.held(key); };
      const auto any = [&](auto keys) { return std::any_of(keys.begin(), keys.end(), held) ? 1.0f : 0.0f; };
      return any(forward) - any(back);
    };
    input.move = {axis({GLFW_KEY_D}, {GLFW_KEY_A}), axis({GLFW_KEY_SPACE, GLFW_KEY_E}, {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_Q}),
                  axis({GLFW_KEY_W}, {GLFW_KEY_S})};
  }
  // Alt and a drag: around what is looked at.
  input.around = window_.held(GLFW_KEY_LEFT_ALT) && !interface_.takes_keys();
  const bool pressed = glfwGetMouseButton(window_.handle(), GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  const bool left = input.around && pressed && !state_panels_.has_mouse();
  const bool looks = (window_.right_button() || left) && !interface_.takes_mouse();
  if (looks) input.look_px = window_.mouse_motion();
  window_.capture_mouse(looks);
  if (!interface_.takes_mouse()) input.wheel = interface_.wheel();
  if (!camera_.update(input, seconds)) return;
  state_panels_.user_moves_camera();
  keep_lens(state, *session_);
  state.view.camera = camera_.camera().text();
}

}  // namespace gnomon::viewer
