#include "app/viewer/opening.h"

#include <fmt/format.h>

#include "scene/load.h"

namespace gnomon::viewer {

Opening::Opening(ViewState state) : state_(std::move(state)) {
  scene_ = std::async(std::launch::async, [this] {
    watch_.watch_this_thread();
    return load_scene(state_.view.scene, state_.settings().scene_options());
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

ViewState state_for_scene(const ViewState& state, const std::string& scene) {
  ViewState next;
  next.view.scene = scene;
  next.view.size = state.view.size;
  next.view.samples = state.view.samples, next.view.fewer_samples = true;
  next.techniques = state.techniques;
  const Settings settings = state.settings();
  for (const std::string& assignment : settings.assignments()) {
    const std::string id = assignment.substr(0, assignment.find('.'));  // with its light, where it is for one
    if (Settings::is_technique_part(id) || id == "frame" || id == "reference") next.base.assign(assignment);
  }
  return next;
}

}  // namespace gnomon::viewer
