// Parsing and distribution of --set.
#include "lab/view/settings.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/lower_case.h"
#include "lab/view/lab_params.h"
#include "scene/load.h"

namespace gnomon {
namespace {

// Every id of every technique, with its table.
const std::map<std::string, ParamTable, std::less<>>& technique_tables() {
  static const auto tables = [] {
    std::map<std::string, ParamTable, std::less<>> result;
    for (const auto& spec : all_techniques()) {
      for (const auto& [id, table] : spec.tables) result.emplace(id, table);
    }
    return result;
  }();
  return tables;
}

std::string valid_ids() {
  std::set<std::string> ids;
  for (const auto& [id, table] : lab_tables()) ids.insert(id);
  for (const auto& [id, table] : technique_tables()) {
    if (!table.empty()) ids.insert(id);
  }
  return fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

std::vector<std::pair<std::string, ParamTable>> lab_tables() {
  return {{"light", light_params::param_table_storage()},     {"camera", camera_params::param_table_storage()},
          {"frame", frame_params::param_table_storage()},     {"reference", reference_params::param_table_storage()},
          {"measure", measure_params::param_table_storage()}, {"scene", scene_file_params::param_table_storage()}};
}

Settings::Settings() {
  for (const auto& [id, table] : lab_tables()) blocks_.emplace(id, ParamBlock(table));
}

void Settings::assign(std::string_view assignment, std::string_view source) {
  const std::string_view whole = assignment;
  std::string light;
  if (const size_t at = assignment.find('@'); at != assignment.npos && at < assignment.find('=')) {
    light = assignment.substr(0, at);
    assignment.remove_prefix(at + 1);
  }
  const size_t dot = assignment.find('.'), equals = assignment.find('=');
  if (dot == assignment.npos || equals == assignment.npos || dot > equals) {
    fail_usage("{} {}: not of the form id.key=value; valid ids: {}", source, assignment, valid_ids());
  }
  const std::string id(assignment.substr(0, dot)), name(assignment.substr(dot + 1, equals - dot - 1));
  const std::string value(assignment.substr(equals + 1));
  // An option of its own, such as --up, says all; a preset's name does not.
  const std::string where = source == "--set"          ? id + "." + name
                            : source.starts_with("--") ? std::string(source)
                                                       : fmt::format("{} {}.{}", source, id, name);
  if (!light.empty() && !is_technique_part(id))
    fail_usage("{} {}: '{}' is no part of a technique; only those have values of their own for a light", source, whole, id);
  if (id == "scene") {
    assign_to_scene(name, value, where);
  } else if (const auto block = blocks_.find(id); block != blocks_.end()) {
    block->second.set(name, value, where);
  } else if (const auto table = technique_tables().find(id); table != technique_tables().end()) {
    ParamBlock(table->second).set(name, value, where);  // refuses a bad value now
    of_techniques_.push_back({id, name, value, light, std::string(source)});
  } else {
    fail_usage("{} {}: unknown id '{}'; valid: {}", source, assignment, id, valid_ids());
  }
  assignments_.emplace_back(whole);
}

namespace {

// A parameter's choices are words that every language takes; people write -z, and Z.
std::string axis_name(const std::string& text, const std::string& where) {
  const std::string axis = lower_case(text);
  if (axis == "-z") return "minus_z";
  for (const char* valid : {"y", "z", "x", "minus_z"}) {
    if (axis == valid) return axis;
  }
  fail_usage("{}: '{}' is not valid; valid: one of y, z, x, -z", where, text);
}

}  // namespace

// What a file is read with has a table; anything else is an option of a built-in scene, which checks it itself.
void Settings::assign_to_scene(const std::string& name, const std::string& value, const std::string& where) {
  ParamBlock& block = blocks_.at("scene");
  if (std::any_of(block.table().begin(), block.table().end(), [&](const ParamInfo& info) { return info.name == name; })) {
    block.set(name, name == "up" ? axis_name(value, where) : value, where);
  } else if (const auto text = std::find_if(std::begin(k_scene_file_texts), std::end(k_scene_file_texts),
                                            [&](const SceneFileText& known) { return known.name == name; });
             text != std::end(k_scene_file_texts)) {
    scene_texts_.*text->value = value;
  } else {
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || end != value.data() + value.size()) fail_usage("{}: '{}' is not a number", where, value);
    scene_options_[name] = number;
  }
}

SceneFileOptions Settings::scene_file_options() const {
  SceneFileOptions options = scene_texts_;
  options.params = block("scene").as<scene_file_params::Params>();
  const auto note = [&](std::string_view name) {
    if (was_set("scene." + std::string(name))) options.given.emplace_back(name);
  };
  for (const ParamInfo& info : block("scene").table()) note(info.name);
  for (const SceneFileText& text : k_scene_file_texts) note(text.name);
  return options;
}

std::map<std::string, std::string> Settings::scene_texts() const {
  std::map<std::string, std::string> texts;
  for (const auto& [name, value] : scene_options_) texts[name] = fmt::format("{}", value);
  if (!scene_is_file_) return texts;
  for (const ParamInfo& info : block("scene").table()) texts[std::string(info.name)] = block("scene").text(info.name);
  for (const SceneFileText& text : k_scene_file_texts) {
    if (const std::string& value = scene_texts_.*text.value; !value.empty()) texts[std::string(text.name)] = value;
  }
  return texts;
}

bool Settings::is_technique_part(std::string_view id) { return technique_tables().contains(id); }

const ParamBlock& Settings::block(std::string_view id) const {
  const auto found = blocks_.find(id);
  GNOMON_ASSERT(found != blocks_.end());
  return found->second;
}

bool Settings::was_set(std::string_view key) const {
  return std::any_of(assignments_.begin(), assignments_.end(), [&](const std::string& text) {
    return text.size() > key.size() && text.starts_with(key) && text[key.size()] == '=';
  });
}

void Settings::set_effective(std::string_view id, std::string_view name, double value) {
  const auto found = blocks_.find(id);
  GNOMON_ASSERT(found != blocks_.end());
  const auto& table = found->second.table();
  const auto info = std::find_if(table.begin(), table.end(), [&](const ParamInfo& param) { return param.name == name; });
  GNOMON_ASSERT(info != table.end());
  found->second.set_number(name, std::clamp(value, info->min, info->max), name);
}

SettingsMap Settings::for_technique(const TechniqueSpec& spec, std::string_view light) const {
  SettingsMap settings = spec.default_settings();
  for (const bool of_one_light : {false, true}) {
    for (const Assignment& a : of_techniques_) {
      if (of_one_light ? a.light.empty() || a.light != light : !a.light.empty()) continue;
      if (const auto block = settings.find(a.id); block != settings.end())
        block->second.set(a.name, a.value, a.id + "." + a.name);
    }
  }
  return settings;
}

std::vector<std::string> Settings::lights_named() const {
  std::set<std::string> names;
  for (const Assignment& a : of_techniques_) {
    if (!a.light.empty()) names.insert(a.light);
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> Settings::assignments_for(const TechniqueSpec& spec) const {
  std::vector<std::string> result;
  for (const std::string& text : assignments_) {
    const size_t equals = text.find('='), at = text.find('@');
    const size_t begin = at != text.npos && at < equals ? at + 1 : 0;
    const std::string_view id = std::string_view(text).substr(begin, text.find('.', begin) - begin);
    const bool of_technique =
        std::any_of(spec.tables.begin(), spec.tables.end(), [&](const auto& table) { return table.first == id; });
    if (of_technique || id == "scene" || blocks_.contains(id)) result.push_back(text);
  }
  return result;
}

void Settings::complete_scene_options(const std::string& scene) {
  scene_is_file_ = !is_builtin_scene(scene);
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != scene) continue;
    for (const BuiltinOption& option : builtin.options) scene_options_.try_emplace(option.name, option.default_value);
  }
}

void Settings::check_used(const std::vector<const TechniqueSpec*>& techniques) const {
  for (const auto& [id, name, value, light, source] : of_techniques_) {
    const bool used = std::any_of(techniques.begin(), techniques.end(), [&](const TechniqueSpec* spec) {
      return std::any_of(spec->tables.begin(), spec->tables.end(), [&](const auto& table) { return table.first == id; });
    });
    if (!used) fail_usage("{} {}.{}={}: no technique of this run has the part '{}'", source, id, name, value, id);
  }
}

nlohmann::json Settings::to_json(const SettingsMap& technique) const {
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [id, block] : technique) object[id] = block.to_json();
  for (const auto& [id, block] : blocks_) object[id] = block.to_json();
  if (!scene_is_file_) object["scene"] = nlohmann::json::object();
  object["scene"].update(nlohmann::json(scene_options_));
  for (const SceneFileText& text : k_scene_file_texts) {
    if (const std::string& value = scene_texts_.*text.value; !value.empty()) object["scene"][std::string(text.name)] = value;
  }
  return object;
}

}  // namespace gnomon
