// gnomon describe: a technique's manual page and parameter tables.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "lab/plan/preset.h"

namespace gnomon::cli {
namespace {

nlohmann::json param_json(const ParamInfo& info, const ParamBlock& defaults) {
  nlohmann::json json = {{"name", info.name},
                         {"default", defaults.to_json()[std::string(info.name)]},
                         {"update", info.update == ParamUpdate::live ? "live" : "rebuild"},
                         {"help", info.help},
                         {"unit", info.unit()}};
  if (info.type == ParamType::choice) {
    json["choices"] = info.choices;
  } else if (info.type != ParamType::bool_) {
    json["min"] = info.min;
    json["max"] = info.max;
  }
  return json;
}

void print_table(const std::string& id, ParamTable table) {
  const ParamBlock defaults(table);
  for (const ParamInfo& info : table) {
    std::cout << fmt::format("  {:<28} {:<10} {}\n", fmt::format("{}.{}", id, info.name), defaults.text(info.name), info.help);
    std::cout << fmt::format("  {:<28} {:<10} {}{}\n", "", "", info.valid_text(),
                             info.update == ParamUpdate::rebuild ? "; rebuilds" : "");
  }
}

void describe(const std::string& name, bool json) {
  const TechniqueSpec& spec = find_technique(name);
  std::vector<std::string_view> lights;
  for (const LightKind kind : spec.light_kinds) lights.push_back(light_kind_name(kind));
  if (json) {
    nlohmann::json object = {{"name", spec.name}, {"summary", spec.summary}, {"manual", spec.manual}, {"lights", lights}};
    object["parameters"] = nlohmann::json::object();
    for (const auto& [id, table] : spec.tables) {
      object["parameters"][id] = nlohmann::json::array();
      for (const ParamInfo& info : table) object["parameters"][id].push_back(param_json(info, ParamBlock(table)));
    }
    std::cout << object.dump(2) << "\n";
    return;
  }
  std::cout << spec.name << "\n\n"
            << spec.manual << "\n\nLights: " << fmt::format("{}", fmt::join(lights, ", "))
            << "\n\nParameters (--set id.key=value):\n";
  for (const auto& [id, table] : spec.tables) print_table(id, table);
  std::cout << "\nOf every run:\n";
  for (const auto& [id, table] : lab_tables()) print_table(id, table);
}

// A preset's own file, as it would be written; false where none has that name.
bool describe_preset(const std::string& name) {
  for (const Preset& preset : builtin_presets()) {
    if (preset.name == name) return std::cout << preset_text(preset), true;
  }
  return false;
}

struct Arguments {
  std::string technique;
  bool json = false;
};

}  // namespace

void add_describe(CLI::App& app, const Globals&) {
  auto* command = app.add_subcommand("describe", "a technique's manual page and parameter table");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("technique", arguments->technique, "projection/filter or a direct technique (gnomon list), or a preset")
      ->required();
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([arguments] {
    if (!describe_preset(arguments->technique)) describe(arguments->technique, arguments->json);
  });
}

}  // namespace gnomon::cli
