// Arguments that subcommands share.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "app/cli/command.h"
#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "lab/experiment/compare.h"
#include "lab/view/light_text.h"
#include "lab/view/preset_use.h"
#include "report/report.h"

namespace gnomon::cli {

std::unique_ptr<Device> Globals::open_device() const { return std::make_unique<Device>(device); }

void ViewArguments::add_to(CLI::App& command) {
  command_ = &command;
  command.add_option("scene", scene, "built-in scene (gnomon list scenes) or path to .obj, .gltf, .glb");
  command.add_option("--size", size, "width x height of the picture, e.g. 1280x720")->capture_default_str();
  command.add_option("--samples", samples, "samples per pixel: 1, 2, 4, 8 as the device offers")->capture_default_str();
  command.add_option("--camera", camera, "'frame', 'x,y,z:x,y,z' (eye and target), or name or number of a camera of the scene");
  command.add_option("--light", lights,
                     std::string("'sun', 'all', name or number of a light of the scene, or ") + k_light_text_help +
                         "; repeat for several (default: the scene's first sun, else all its lights)");
  command.add_option(
      "--cast", casts,
      "GLOB=on or GLOB=off: whether objects or materials of that name (or of names that fit, with *, ?, [...]) cast "
      "shadows; repeat for several, the last "
      "that fits counts");
  command.add_option("--up", up, "the axis of the file that points up: y, z, x or -z");
  command.add_option("--gltf-scene", gltf_scene, "name or number of one of the scenes of a glTF file");
  command.add_option("--animation", animation, "name or number of an animation of a glTF file (default: the first)");
  command.add_option("--time", time, "seconds into the animation at which the scene is posed (default: 0)");
  command.add_option("--set", assignments, "id.key=value, e.g. pcf.size=5 or light.elevation=30 (gnomon describe TECHNIQUE)");
  command.add_option(
      "--preset", preset_names,
      "settings from a JSON file or a built-in preset (gnomon list presets); later ones and other arguments win");
  command.add_option("--write-preset", written_preset, "also writes all settings in force as a preset");
}

void add_against(CLI::App& command, std::string& against) {
  command
      .add_option("--against", against,
                  "the truth that errors are sorted and judged by: pixel (what each pixel should show), area (the light in its "
                  "real size), "
                  "hard (one ray to its middle)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(k_truth_names), std::end(k_truth_names))))
      ->capture_default_str();
}

uvec2 parse_size(const std::string& size) {
  const size_t x = size.find('x');
  const auto number = [&](std::string_view text) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || value < 1 || value > 16384) fail_usage("--size {}: valid: WIDTHxHEIGHT, each from 1 to 16384", size);
    return value;
  };
  if (x == size.npos) number("");
  return {number(std::string_view(size).substr(0, x)), number(std::string_view(size).substr(x + 1))};
}

bool ViewArguments::given(const char* option) const { return command_->get_option(option)->count() > 0; }

bool ViewArguments::other_scene(const Preset& preset) const { return given("scene") && scene != preset.scene.value_or(scene); }

Preset ViewArguments::preset() const {
  Preset merged;
  for (const std::string& name : preset_names) {
    const Preset preset = load_preset(name);
    check_preset(preset);
    overlay(merged, preset);
    merged.name += (merged.name.empty() ? "" : ", ") + preset.name;
  }
  return merged;
}

ViewOptions ViewArguments::view() const {
  ViewOptions options;
  options.size = parse_size(size);
  options.samples = samples;
  Preset used = preset();
  if (other_scene(used)) {
    for (const std::string& rule : used.casts) log_info("preset {}: casts {} is left out: another scene", used.name, rule);
    used.casts.clear();
  }
  apply_view(used, options);
  if (given("scene")) options.scene = scene;
  if (options.scene.empty()) options.scene = scene;  // a subcommand's default
  if (options.scene.empty()) fail_usage("scene is required: a name, a path, or a --preset that has one");
  if (given("--size")) options.size = parse_size(size);
  if (given("--samples")) options.samples = samples, options.fewer_samples = false;
  if (given("--camera")) options.camera = camera;
  if (given("--light")) options.lights = lights;
  if (given("--cast")) options.casts.insert(options.casts.end(), casts.begin(), casts.end());
  for (const std::string& rule : casts) options.cast_sources.erase(rule);
  return options;
}

Settings ViewArguments::settings(const std::vector<std::string>& techniques) const {
  Preset used = preset();
  const auto specs = techniques_named(techniques);
  const bool other_techniques = techniques != used.techniques, is_other_scene = other_scene(used);
  std::erase_if(used.set, [&](const auto& setting) {
    const size_t at = setting.first.find('@'), begin = at == setting.first.npos ? 0 : at + 1;  // behind the name of a light
    const std::string id = setting.first.substr(begin, setting.first.find('.', begin) - begin);
    const bool has_part = std::any_of(specs.begin(), specs.end(),
                                      [&](const TechniqueSpec* spec) { return spec->default_settings().contains(id); });
    const bool is_useless =
        (other_techniques && Settings::is_technique_part(id) && !has_part) || (is_other_scene && id == "scene");
    if (is_useless)
      log_info("preset {}: {} is left out: {}", used.name, setting.first,
               id == "scene" ? "another scene" : "no technique of this run has it");
    return is_useless;
  });
  Settings settings;
  assign_preset(settings, used);
  const auto assign_scene = [&](const char* option, const char* key, const std::string& value) {
    if (given(option)) settings.assign(fmt::format("scene.{}={}", key, value), option);
  };
  assign_scene("--up", "up", up);
  assign_scene("--gltf-scene", "gltf_scene", gltf_scene);
  assign_scene("--animation", "animation", animation);
  assign_scene("--time", "time", time);
  for (const std::string& assignment : assignments) settings.assign(assignment);
  return settings;
}

void ViewArguments::write_preset(const std::vector<std::string>& techniques, bool together) const {
  if (written_preset.empty()) return;
  Settings effective = settings(techniques);
  const ViewOptions options = view();
  effective.complete_scene_options(options.scene);
  Preset written = effective_preset(options, techniques, effective);
  written.together = together;
  write_file(written_preset, preset_text(written));
}

}  // namespace gnomon::cli
