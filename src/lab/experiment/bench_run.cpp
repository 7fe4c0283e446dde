// From a suite's data to settings; scaling for small devices.
#include "lab/experiment/bench_run.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "lab/view/preset_use.h"
#include "scene/load.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

constexpr double k_quick_detail = 0.1;

uint32_t scaled(uint32_t side, double scale, uint32_t least) {
  return scale == 1.0 ? side : std::max(least, static_cast<uint32_t>(std::lround(side * scale)));
}

const BuiltinOption* scene_option(const std::string& scene, const std::string& option) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != scene) continue;
    const auto found = std::find_if(builtin.options.begin(), builtin.options.end(),
                                    [&](const BuiltinOption& item) { return item.name == option; });
    if (found != builtin.options.end()) return &*found;
  }
  return nullptr;
}

// Settings for all runs reach those that have the part: a suite has runs of many techniques and scenes.
Preset applicable(const Preset& preset, const std::string& scene, const TechniqueSpec* spec) {
  Preset result = preset;
  std::erase_if(result.set, [&](const auto& setting) {
    const size_t dot = setting.first.find('.');
    const std::string id = setting.first.substr(0, dot);
    if (id == "scene") return scene_option(scene, setting.first.substr(dot + 1)) == nullptr;
    if (!Settings::is_technique_part(id)) return false;
    return !spec ||
           std::none_of(spec->tables.begin(), spec->tables.end(), [&](const auto& table) { return table.first == id; });
  });
  return result;
}

Preset quick_settings(const std::string& scene) {
  Preset preset;
  preset.name = "--quick";
  preset.set = {{"measure.frames", "5"}, {"measure.warm_up", "1"}, {"measure.max_seconds", "0.5"}};
  if (const BuiltinOption* detail = scene_option(scene, "detail")) {
    preset.set.emplace_back("scene.detail", fmt::format("{}", std::max(detail->min, k_quick_detail)));
  }
  return preset;
}

void scale_maps(SettingsMap& values, double scale) {
  for (const ProjectionInfo& projection : projections()) {
    const auto block = values.find(projection.id);
    if (block == values.end()) continue;
    for (const ParamInfo& info : projection.params) {
      if (info.name != "size") continue;
      const double size = std::max(info.min, std::round(block->second.number("size") * scale));
      block->second.set_number("size", size, projection.id + ".size");
    }
  }
}

}  // namespace

std::string BenchRun::technique() const { return spec ? spec->name : "kernel/" + run->kernel; }

std::string BenchRun::view_key() const {
  nlohmann::json key = {view.scene,         view.size.x, view.size.y, view.samples,
                        view.fewer_samples, view.camera, view.lights, view.casts};
  key.push_back(settings.to_json({}));
  return key.dump();
}

nlohmann::json BenchRun::all_settings() const {
  nlohmann::json object = settings.to_json(values);
  if (!spec) object["kernel"] = {{"texels", texels}};
  return object;
}

BenchRun prepare_run(const SuiteRun& run, const BenchOptions& options) {
  BenchRun result;
  result.run = &run;
  check_preset(run.view);
  result.spec = run.kernel.empty() ? &find_technique(run.view.techniques.front()) : nullptr;
  apply_view(run.view, result.view);
  // A camera or light by name belongs to the scene that the suite chose it for.
  apply_view(options.override, result.view);
  const std::string& scene = result.view.scene;
  if (result.spec) {
    assign_preset(result.settings, run.view);
    try {
      result.settings.check_used({result.spec});
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", run.view.name, error.what()), error.code());
    }
  } else {
    assign_preset(result.settings, applicable(run.view, scene, nullptr));
  }
  if (options.quick) assign_preset(result.settings, quick_settings(scene));
  assign_preset(result.settings, applicable(options.override, scene, result.spec));
  result.settings.complete_scene_options(scene);
  result.view.size = {scaled(result.view.size.x, options.scale, 16), scaled(result.view.size.y, options.scale, 16)};
  if (result.spec) result.values = result.settings.for_technique(*result.spec);
  scale_maps(result.values, options.scale);
  result.texels = scaled(run.texels, options.scale, 16);
  return result;
}

}  // namespace gnomon
