#include "app/viewer/state/view_preset.h"

#include <algorithm>

#include "base/error.h"
#include "lab/view/preset_use.h"

namespace gnomon::viewer {
namespace {

bool starts(const std::string& key, std::initializer_list<const char*> ids) {
  return std::any_of(ids.begin(), ids.end(), [&](const char* id) { return key.starts_with(std::string(id) + "."); });
}

}  // namespace

bool for_other_scene(const ViewState& state, const Preset& preset) { return preset.scene && *preset.scene != state.view.scene; }

Preset preset_of(const ViewState& state, uvec2 size) {
  ViewOptions view = state.view;
  view.size = size;
  view.fewer_samples = false;  // as they are
  Settings settings = state.settings();
  settings.complete_scene_options(view.scene);
  Preset preset = effective_preset(view, state.techniques, settings);
  preset.together = true;
  return preset;
}

ViewState with_preset(const ViewState& state, const Preset& preset, bool keep_view) {
  check_preset(preset);
  const bool keeps = keep_view || for_other_scene(state, preset);
  ViewState next = state;
  if (!preset.techniques.empty()) next.techniques = preset.techniques;
  if (std::find(next.techniques.begin(), next.techniques.end(), "all") != next.techniques.end()) {
    fail_usage("{}: 'techniques' is \"all\"; valid here: names of techniques", preset.name);
  }
  if (preset.samples) next.view.samples = preset.samples->count, next.view.fewer_samples = preset.samples->at_most;
  if (!keeps) next.view.camera = preset.camera.value_or(""), next.view.lights = preset.lights, next.view.casts = preset.casts;
  next.base = {};
  next.edits.clear();
  // What a scene's options were when it was built stays with it; so do place and light, where they are kept.
  const Settings before = state.settings();
  for (const std::string& assignment : before.assignments()) {
    if (starts(assignment, {"scene"}) || (keeps && starts(assignment, {"camera", "light"}))) next.base.assign(assignment);
  }
  for (const auto& [key, value] : preset.set) {
    const bool of_view = starts(key, {"camera", "light"}) || key.find('@') != key.npos;
    if (!starts(key, {"scene"}) && !(keeps && of_view)) next.base.assign(key + "=" + value, preset.name + ": 'set':");
  }
  return next;
}

}  // namespace gnomon::viewer
