// Checks and translations.
#include "lab/view/preset_use.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "lab/experiment/compare.h"
#include "scene/load.h"

namespace gnomon {
namespace {

void check_scene_name(const Preset& preset) {
  const std::string& name = *preset.scene;
  std::string names;
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name == name) return;
    names += scene.name + ", ";
  }
  for (const char* extension : {".obj", ".gltf", ".glb"}) {
    if (name.ends_with(extension)) return;
  }
  fail_usage("{}: 'scene' is \"{}\"; valid: {}or a path to .obj, .gltf, .glb", preset.name, name, names);
}

}  // namespace

void check_preset(const Preset& preset) {
  Settings settings;
  assign_preset(settings, preset);
  for (const std::string& technique : preset.techniques) {
    if (technique == "all") continue;
    try {
      find_technique(technique);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", preset.name, error.what()), error.code());
    }
  }
  if (preset.scene) check_scene_name(preset);
  for (const std::string& rule : preset.casts) check_cast_rule(rule, preset.name);
}

void assign_preset(Settings& settings, const Preset& preset) {
  for (const auto& [key, value] : preset.set) settings.assign(key + "=" + value, preset.name + ": 'set':");
}

void apply_view(const Preset& preset, ViewOptions& view) {
  if (preset.scene) view.scene = *preset.scene;
  if (preset.size) view.size = *preset.size;
  if (preset.samples) view.samples = preset.samples->count, view.fewer_samples = preset.samples->at_most;
  if (preset.camera) view.camera = *preset.camera;
  if (!preset.lights.empty()) view.lights = preset.lights;
  view.casts.insert(view.casts.end(), preset.casts.begin(), preset.casts.end());
  for (const std::string& rule : preset.casts) view.cast_sources[rule] = preset.name;
}

Preset effective_preset(const ViewOptions& view, const std::vector<std::string>& techniques, const Settings& settings) {
  Preset preset;
  preset.scene = view.scene;
  preset.techniques = techniques;
  preset.lights = view.lights;
  preset.casts = view.casts;
  if (!view.camera.empty()) preset.camera = view.camera;
  preset.size = view.size;
  preset.samples = SampleCount{view.samples, view.fewer_samples};
  const auto add_block = [&](const std::string& id, const ParamBlock& block) {
    for (const ParamInfo& info : block.table()) {
      const std::string key = fmt::format("{}.{}", id, info.name);
      // What the scene decides about its lights and cameras is not pinned: a preset that sets it would override the scene.
      const bool of_scene = id == "light" || id == "camera";
      if (!of_scene || settings.was_set(key)) preset.set.emplace_back(key, block.text(info.name));
    }
  };
  for (const auto& [id, table] : lab_tables()) {
    if (id != "scene") add_block(id, settings.block(id));
  }
  const auto specs = techniques_named(techniques);
  for (const TechniqueSpec* spec : specs) {
    for (const auto& [id, block] : settings.for_technique(*spec)) add_block(id, block);
  }
  for (const std::string& assignment : settings.assignments()) {
    const size_t at = assignment.find('@'), equals = assignment.find('=');
    if (at == assignment.npos || at > equals) continue;
    const std::string id = assignment.substr(at + 1, assignment.find('.', at) - at - 1);
    const bool used = std::any_of(specs.begin(), specs.end(),
                                  [&](const TechniqueSpec* spec) { return spec->default_settings().contains(id); });
    if (used) preset.set.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  for (const auto& [name, value] : settings.scene_texts()) preset.set.emplace_back("scene." + name, value);
  return preset;
}

}  // namespace gnomon
