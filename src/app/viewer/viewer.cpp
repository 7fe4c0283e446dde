#include "app/viewer/viewer.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/shell.h"

namespace gnomon::viewer {
namespace {

// A window that is being dragged to another size asks for many; the old picture is stretched meanwhile.
constexpr float k_size_settles_s = 0.2f;
// The longest step of the camera: after a slow frame it does not leap.
constexpr float k_longest_step_s = 0.25f;

uvec2 scaled(uvec2 size, float scale) {
  const vec2 exact = glm::round(vec2(size) * scale);
  return glm::clamp(uvec2(exact), uvec2(1), uvec2(16384));
}

std::unique_ptr<Session> open_session(Device& device, ViewState& state, float scale) {
  state.view.size = scaled(state.view.size, scale);
  auto session = std::make_unique<Session>(device, state.view, state.base);
  state.view.samples = session->options().samples;  // as offered
  return session;
}

std::filesystem::path free_name() {
  for (int number = 0;; ++number) {
    const std::filesystem::path path = fmt::format("gnomon_{:04}.png", number);
    if (!std::filesystem::exists(path)) return path;
  }
}

}  // namespace

Viewer::Viewer(Window& window, Device& device, ViewState state, const ViewerOptions& options)
    : window_(window),
      device_(device),
      options_(options),
      state_(std::move(state)),
      session_(open_session(device, state_, options.scale)),
      interface_(device, window),
      canvas_(device),
      swapchain_(device, window),
      panels_(session_->settings()),
      camera_(session_->camera(), session_->scene().bounds().radius()),
      last_frame_(std::chrono::steady_clock::now()) {
  wishes_.scale = options.scale;
  techniques_.update(*session_, state_.techniques);
}

void Viewer::run() {
  const InterruptScope interrupt;
  for (uint32_t frame = 0; !window_.closing() && (options_.frames == 0 || frame < options_.frames);) {
    check_interrupted();
    const uvec2 size = window_.size();
    const bool visible = size.x > 0 && size.y > 0;
    window_.poll(!visible);
    if (!visible) continue;
    draw();
    ++frame;
  }
  if (!options_.screenshot.empty() && canvas_.image()) write_png(options_.screenshot, canvas_.read());
}

void Viewer::draw() {
  const auto now = std::chrono::steady_clock::now();
  const float seconds = std::chrono::duration<float>(now - last_frame_).count();
  last_frame_ = now;
  const uvec2 size = glm::max(window_.size(), uvec2(1));
  if (!canvas_.image() || canvas_.size() != size) canvas_.resize(size, interface_.render_pass());

  ViewState next = state_;
  interface_.begin_frame();
  handle_keys();
  move_camera(next, std::min(seconds, k_longest_step_s));
  panels_.set_speed(camera_.speed());
  if (wishes_.interface) panels_.show(next, wishes_, *session_, techniques_, timings_);
  panels_.show_message(message_);
  interface_.end_frame();
  if (!next.same_picture(state_)) apply(next);
  follow_size(seconds);

  if (!recorder_ || recorder_separates_ != wishes_.separate_passes) {
    recorder_separates_ = wishes_.separate_passes;
    const bool alone = recorder_separates_ && device_.info().software;
    recorder_ = std::make_unique<Recorder>(device_, recorder_separates_ ? TimingMode::measure : TimingMode::play, alone);
    timings_.clear();
  }
  recorder_->begin();
  session_->record_frame(*recorder_, techniques_.techniques());
  canvas_.record(*recorder_, session_->frame(), interface_);
  timings_.add(recorder_->finish());
  swapchain_.set_vsync(wishes_.vsync);
  swapchain_.present(canvas_.image());
  if (std::exchange(wishes_.screenshot, false)) take_screenshot();
  if (std::exchange(wishes_.copy_command, false)) glfwSetClipboardString(window_.handle(), state_.command(session_->options().size).c_str());
}

void Viewer::handle_keys() {
  if (window_.pressed(GLFW_KEY_F12)) wishes_.screenshot = true;
  if (window_.pressed(GLFW_KEY_F1)) wishes_.interface = !wishes_.interface;
  if (window_.pressed(GLFW_KEY_Q) && window_.control_held()) window_.close();
}

void Viewer::move_camera(ViewState& state, float seconds) {
  CameraInput input;
  if (!interface_.takes_keys() && !window_.control_held()) {
    const auto axis = [&](std::initializer_list<int> forward, std::initializer_list<int> back) {
      const auto any = [&](auto keys) { return std::any_of(keys.begin(), keys.end(), [&](int key) { return window_.held(key); }) ? 1.0f : 0.0f; };
      return any(forward) - any(back);
    };
    input.move = {axis({GLFW_KEY_D}, {GLFW_KEY_A}), axis({GLFW_KEY_SPACE, GLFW_KEY_E}, {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_Q}),
                  axis({GLFW_KEY_W}, {GLFW_KEY_S})};
  }
  const bool looks = window_.right_button() && !interface_.takes_mouse();
  if (looks) input.look_px = window_.mouse_motion();
  window_.capture_mouse(looks);
  if (!interface_.takes_mouse()) input.wheel = interface_.wheel();
  if (!camera_.update(input, seconds)) return;
  // A camera given as text has the lens of the settings: that of the scene's camera goes with it.
  if (!session_->camera().orthographic) {
    for (const char* name : {"vertical_fov", "near"}) {
      state.edits.try_emplace(fmt::format("camera.{}", name), session_->settings().block("camera").text(name));
    }
  }
  state.view.camera = camera_.text();
}

void Viewer::apply(const ViewState& next) {
  try {
    session_->change(next.view, next.settings());
    techniques_.update(*session_, next.techniques);
    if (next.techniques != state_.techniques) timings_.clear();
    state_ = next;
    message_.clear();
  } catch (const Error& error) {
    // What the user may have asked for is shown; what validation says, and a lost device, end the program.
    if (device_.validates() && error.code() == ExitCode::failure) throw;
    message_ = error.what();
    session_->change(state_.view, state_.settings());
    techniques_.update(*session_, state_.techniques);
  }
}

uvec2 Viewer::wanted_size() const { return scaled(window_.size(), wishes_.scale); }

void Viewer::follow_size(float seconds) {
  const uvec2 wanted = wanted_size();
  const bool settled = wanted == state_.view.size;  // as it was a frame ago
  state_.view.size = wanted;
  size_waits_s_ = settled ? size_waits_s_ + seconds : 0.0f;
  if (wanted == session_->options().size || size_waits_s_ < k_size_settles_s || glfwGetMouseButton(window_.handle(), GLFW_MOUSE_BUTTON_LEFT)) {
    return;
  }
  techniques_.clear();
  session_->resize(wanted);
  techniques_.update(*session_, state_.techniques);
}

void Viewer::take_screenshot() {
  const std::filesystem::path path = free_name();
  write_png(path, session_->frame().read_display());
  std::cout << path.string() << std::endl;
  log_info("{} -o {}", state_.command(session_->options().size), shell_quoted(path.string()));
}

}  // namespace gnomon::viewer
