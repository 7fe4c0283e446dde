#include "app/viewer/window/screen.h"

namespace gnomon::viewer {

void Screen::fit_canvas() {
  const uvec2 size = glm::max(window.size(), uvec2(1));
  if (!canvas.image() || canvas.size() != size) canvas.resize(size, interface.render_pass());
}

void Screen::show_panels(const std::function<void()>& panels) {
  fit_canvas();
  interface.begin_frame();
  panels();
  interface.end_frame();
  Recorder recorder(device, TimingMode::play, false);
  recorder.begin();
  canvas.record_empty(recorder, interface);
  recorder.finish();
  swapchain.present(canvas.image());
}

}  // namespace gnomon::viewer
