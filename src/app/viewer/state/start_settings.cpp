#include "app/viewer/state/start_settings.h"

namespace gnomon::viewer {

Settings start_settings(const ViewState& state, const Scene& scene) {
  Settings settings = state.base;
  choose_camera(scene, state.view, settings);
  record_light(choose_lights(scene, state.view, settings).front(), settings);
  return settings;
}

}  // namespace gnomon::viewer
