#include "app/viewer/view_state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/shell.h"

namespace gnomon::viewer {

const TechniqueSpec* technique_for(const std::vector<std::string>& names, LightKind kind) {
  for (const std::string& name : names) {
    const TechniqueSpec& spec = find_technique(name);
    if (spec.supports(kind)) return &spec;
  }
  return nullptr;
}

Settings ViewState::settings() const {
  Settings settings = base;
  for (const auto& [key, value] : edits) settings.assign(key + "=" + value);
  return settings;
}

void ViewState::choose_technique(const TechniqueSpec& spec, LightKind kind, std::span<const Light> lights) {
  std::vector<const TechniqueSpec*> chosen;
  for (const Light& light : lights) {
    const TechniqueSpec* of_light = light.kind == kind ? &spec : technique_for(techniques, light.kind);
    if (of_light && std::find(chosen.begin(), chosen.end(), of_light) == chosen.end()) chosen.push_back(of_light);
  }
  // Those for few kinds of light first: each light then takes its own.
  std::stable_sort(chosen.begin(), chosen.end(), [](const auto* a, const auto* b) { return a->light_kinds.size() < b->light_kinds.size(); });
  techniques.clear();
  for (const TechniqueSpec* of_light : chosen) techniques.push_back(of_light->name);
}

std::string ViewState::command(uvec2 size) const {
  std::string command = fmt::format("gnomon render {} --size {}x{}", shell_quoted(view.scene), size.x, size.y);
  if (view.samples != 1) command += fmt::format(" --samples {}", view.samples);
  if (!view.camera.empty()) command += " --camera " + shell_quoted(view.camera);
  for (const std::string& light : view.lights) command += " --light " + shell_quoted(light);
  command += fmt::format(" --technique {}", fmt::join(techniques, ","));
  const auto add = [&](const std::string& key, const std::string& value) {
    const size_t at = key.find('@');
    const std::string id = key.substr(at == key.npos ? 0 : at + 1, key.find('.') - (at == key.npos ? 0 : at + 1));
    // What belongs to a technique that is no longer shown would be refused.
    const bool used = !Settings::is_technique_part(id) || std::any_of(techniques.begin(), techniques.end(), [&](const std::string& name) {
      return find_technique(name).default_settings().contains(id);
    });
    if (used) command += " --set " + shell_quoted(key + "=" + value);
  };
  for (const std::string& assignment : base.assignments()) {
    const size_t equals = assignment.find('=');
    if (!edits.contains(assignment.substr(0, equals))) add(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  for (const auto& [key, value] : edits) add(key, value);
  return command;
}

bool ViewState::same_picture(const ViewState& other) const {
  return view.camera == other.view.camera && techniques == other.techniques && edits == other.edits;
}

}  // namespace gnomon::viewer
