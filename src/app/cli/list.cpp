// gnomon list: what there is.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "lab/plan/preset.h"
#include "lab/plan/suite.h"
#include "scene/load.h"

namespace gnomon::cli {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;  // name, summary

Rows technique_rows() {
  Rows rows;
  for (const auto& spec : all_techniques()) rows.emplace_back(spec.name, spec.summary);
  return rows;
}

Rows scene_rows() {
  Rows rows;
  for (const auto& scene : builtin_scenes()) {
    std::string options;
    for (const auto& option : scene.options) {
      options += fmt::format("{}scene.{} ({}, {} to {}): {}", options.empty() ? " Options: " : "; ", option.name,
                             option.default_value, option.min, option.max, option.help);
    }
    rows.emplace_back(scene.name, scene.summary + options);
  }
  return rows;
}

Rows preset_rows() {
  Rows rows;
  for (const auto& preset : builtin_presets())
    rows.emplace_back(preset.name, fmt::format("{} ({})", preset.description, preset.source));
  return rows;
}

Rows suite_rows() {
  Rows rows;
  for (const auto& suite : builtin_suites())
    rows.emplace_back(suite.name, fmt::format("{} ({})", suite.description, suite.source));
  return rows;
}

Rows metric_rows() {
  return {{"mae",
           "mean absolute difference between mask and reference, over receivers; this and the next six against pixel, area and "
           "hard"},
          {"rmse", "root of the mean squared difference, over receivers"},
          {"bias", "mean signed difference, mask - reference"},
          {"false_shadow.area", "share of receivers that are darker than the reference by more than 1/255"},
          {"false_shadow.severity", "mean difference among those"},
          {"false_light.area", "share of receivers that are brighter than the reference by more than 1/255"},
          {"false_light.severity", "mean difference among those"},
          {"reference.pixel.uncovered", "share of receivers without enough points on their surface: not judged against pixel"},
          {"image.rmse", "root mean squared difference of the shaded pictures, display values"},
          {"image.psnr", "the same in dB"}};
}

Rows device_rows() {
  Rows rows;
  const auto infos = list_devices();
  for (size_t i = 0; i < infos.size(); ++i) {
    const std::string lacks =
        infos[i].missing.empty() ? "" : fmt::format(", unusable: lacks {}", fmt::join(infos[i].missing, ", "));
    rows.emplace_back(std::to_string(i), fmt::format("{} ({}, {} {}{})", infos[i].name, infos[i].type, infos[i].driver,
                                                     infos[i].driver_version, lacks));
  }
  return rows;
}

void print(const Rows& rows, bool json) {
  if (json) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& [name, summary] : rows) list.push_back({{"name", name}, {"summary", summary}});
    std::cout << list.dump(2) << "\n";
    return;
  }
  size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.first.size());
  for (const auto& [name, summary] : rows) std::cout << fmt::format("{:<{}}  {}\n", name, width, summary);
}

struct Arguments {
  std::string what = "techniques";
  bool json = false;
};

}  // namespace

void add_list(CLI::App& app, const Globals&) {
  auto* command = app.add_subcommand("list", "techniques, scenes, presets, suites, metrics, devices");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("what", arguments->what, "what to list")
      ->check(CLI::IsMember({"techniques", "scenes", "presets", "suites", "metrics", "devices"}))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([arguments] {
    const auto rows = arguments->what == "techniques" ? technique_rows()
                      : arguments->what == "scenes"   ? scene_rows()
                      : arguments->what == "presets"  ? preset_rows()
                      : arguments->what == "suites"   ? suite_rows()
                      : arguments->what == "metrics"  ? metric_rows()
                                                      : device_rows();
    print(rows, arguments->json);
  });
}

}  // namespace gnomon::cli
