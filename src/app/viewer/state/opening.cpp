#include "app/viewer/state/opening.h"

#include <fmt/format.h>

#include "scene/load.h"

namespace gnomon::viewer {

Opening::Opening(ViewState state) : state_(std::move(state)) {
  scene_ = std::async(std::launch::async, [this] {
    watch_.watch_this_thread();
    Cancellation::heed(&cancellation_);
    const Settings settings = state_.settings();
    return load_scene(state_.view.scene, settings.scene_options(), settings.scene_file_options());
  });
}

std::string Opening::status() const {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const ProgressWatch::State now = watch_.state();
  return fmt::format("opening {}{}{} ({:.0f} s)", state_.view.scene, now.title.empty() ? "" : ": ", now.title, seconds);
}

bool Opening::ready() const { return scene_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

std::unique_ptr<Session> Opening::finish(Device& device, uvec2 size) {
  Scene scene = scene_.get();
  state_.view.size = size;
  auto session = std::make_unique<Session>(device, state_.view, state_.settings(), std::move(scene));
  state_.view.samples = session->options().samples;  // as offered
  return session;
}

}  // namespace gnomon::viewer
