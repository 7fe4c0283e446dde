#include "app/viewer/state/view_state.h"

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

std::vector<std::string> names_in_force(const std::vector<std::string>& names, std::span<const Light> lights) {
  std::vector<std::string> in_force;
  for (const Light& light : lights) {
    const TechniqueSpec* spec = technique_for(names, light.kind);
    if (spec && std::find(in_force.begin(), in_force.end(), spec->name) == in_force.end()) in_force.push_back(spec->name);
  }
  return in_force;
}

std::string part_of(const std::string& key) {
  const size_t at = key.find('@'), begin = at == key.npos ? 0 : at + 1;  // a light's name may hold points
  return key.substr(begin, key.find('.', begin) - begin);
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
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const auto* a, const auto* b) { return a->light_kinds.size() < b->light_kinds.size(); });
  techniques.clear();
  for (const TechniqueSpec* of_light : chosen) techniques.push_back(of_light->name);
}

void ViewState::complete_techniques(std::span<const Light> lights, std::span<const std::string> before) {
  std::vector<std::string> candidates(before.begin(), before.end());
  candidates.insert(candidates.end(), {"single/pcf", "cube/pcf"});  // for every kind of light
  for (const Light& light : lights) {
    if (technique_for(techniques, light.kind)) continue;
    if (const TechniqueSpec* spec = technique_for(candidates, light.kind)) techniques.push_back(spec->name);
  }
}

std::string ViewState::command(uvec2 size) const {
  std::string command = "gnomon";
  for (const std::string& word : words("render", "--technique", size)) command += " " + shell_quoted(word);
  return command;
}

std::vector<std::string> ViewState::words(const std::string& subcommand, const std::string& technique_option,
                                          uvec2 size) const {
  std::vector<std::string> words = {subcommand, view.scene, "--size", fmt::format("{}x{}", size.x, size.y)};
  const auto add_option = [&](const char* option, const std::string& value) { words.insert(words.end(), {option, value}); };
  if (view.samples != 1) add_option("--samples", std::to_string(view.samples));
  if (!view.camera.empty()) add_option("--camera", view.camera);
  for (const std::string& light : view.lights) add_option("--light", light);
  for (const std::string& cast : view.casts) add_option("--cast", cast);
  add_option(technique_option.c_str(), fmt::format("{}", fmt::join(techniques, ",")));
  const auto add = [&](const std::string& key, const std::string& value) {
    const std::string id = part_of(key);
    // What belongs to a technique that is no longer shown would be refused.
    const bool used =
        !Settings::is_technique_part(id) || std::any_of(techniques.begin(), techniques.end(), [&](const std::string& name) {
          return find_technique(name).default_settings().contains(id);
        });
    if (used) add_option("--set", key + "=" + value);
  };
  for (const std::string& assignment : base.assignments()) {
    const size_t equals = assignment.find('=');
    if (!edits.contains(assignment.substr(0, equals))) add(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  for (const auto& [key, value] : edits) add(key, value);
  return words;
}

bool ViewState::same_but_camera(const ViewState& other) const {
  return view.lights == other.view.lights && view.casts == other.view.casts && view.samples == other.view.samples &&
         techniques == other.techniques && edits == other.edits && base.assignments() == other.base.assignments();
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
