// Reading, merging, writing.
#include "lab/plan/preset.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <span>

#include "base/error.h"
#include "base/file.h"
#include "lab/plan/fields.h"

namespace gnomon {

// Made by the build (cmake/gnomon_embed.cmake) from presets/*.json.
std::span<const std::pair<std::string_view, std::string_view>> embedded_presets();

namespace {

using nlohmann::json;

uvec2 read_size(const Fields& fields) {
  const json& value = fields.at("size");
  const auto is_side = [](const json& side) {
    return side.is_number_integer() && side.get<int64_t>() >= 1 && side.get<int64_t>() <= 16384;
  };
  if (!value.is_array() || value.size() != 2 || !is_side(value[0]) || !is_side(value[1])) {
    fields.fail_value("size", "[width, height], each from 1 to 16384");
  }
  return {value[0].get<uint32_t>(), value[1].get<uint32_t>()};
}

SampleCount read_samples(const Fields& fields) {
  const json& value = fields.at("samples");
  constexpr const char* k_valid = "a number from 1 to 64, or \"up to N\"";
  if (value.is_number_integer() && value.get<int64_t>() >= 1 && value.get<int64_t>() <= 64)
    return {value.get<uint32_t>(), false};
  constexpr std::string_view k_up_to = "up to ";
  if (!value.is_string() || !value.get_ref<const std::string&>().starts_with(k_up_to)) fields.fail_value("samples", k_valid);
  const std::string text = value.get<std::string>().substr(k_up_to.size());
  SampleCount samples = {0, true};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), samples.count);
  if (error != std::errc() || end != text.data() + text.size() || samples.count < 1 || samples.count > 64)
    fields.fail_value("samples", k_valid);
  return samples;
}

std::vector<std::pair<std::string, std::string>> read_set(const Fields& fields) {
  const json& object = fields.at("set");
  if (!object.is_object()) fields.fail_value("set", "an object such as {\"cascaded.size\": 2048}");
  std::vector<std::pair<std::string, std::string>> set;
  for (const auto& [key, value] : object.items()) {
    const size_t dot = key.find('.');
    if (dot == key.npos || dot == 0 || dot + 1 == key.size())
      fail_usage("{}: 'set' has the key '{}'; valid: id.key, such as cascaded.size", fields.where(), key);
    if (!value.is_number() && !value.is_boolean() && !value.is_string()) {
      fail_usage("{}: 'set': '{}' is {}; valid: a number, true, false, or a choice's name", fields.where(), key, value.dump());
    }
    set.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return set;
}

// "2048" -> 2048, "true" -> true, "mixed" -> "mixed".
json value_of(const std::string& text) {
  const json value = json::parse(text, nullptr, false);
  return value.is_number() || value.is_boolean() ? value : json(text);
}

}  // namespace

Preset read_preset(const json& object, const std::string& name) {
  const Fields fields(
      object, name,
      {"description", "source", "scene", "technique", "techniques", "lights", "casts", "camera", "size", "samples", "set"});
  Preset preset;
  preset.name = name;
  preset.description = fields.text("description").value_or("");
  preset.source = fields.text("source").value_or("");
  preset.scene = fields.text("scene");
  preset.camera = fields.text("camera");
  if (fields.has("technique") && fields.has("techniques"))
    fail_usage("{}: has both 'technique' and 'techniques'; valid: one of them", name);
  preset.techniques = fields.texts(fields.has("technique") ? "technique" : "techniques");
  preset.together = fields.has("technique");
  preset.lights = fields.texts("lights");
  preset.casts = fields.texts("casts");
  if (fields.has("size")) preset.size = read_size(fields);
  if (fields.has("samples")) preset.samples = read_samples(fields);
  if (fields.has("set")) preset.set = read_set(fields);
  return preset;
}

Preset parse_preset(std::string_view text, const std::string& name) { return read_preset(parse_plan(text, name), name); }

const std::vector<Preset>& builtin_presets() {
  static const auto presets = parse_embedded(embedded_presets(), parse_preset);
  return presets;
}

Preset load_preset(const std::string& name_or_path) {
  std::vector<std::string> names;
  for (const Preset& preset : builtin_presets()) {
    if (preset.name == name_or_path) return preset;
    names.push_back(preset.name);
  }
  if (!std::filesystem::is_regular_file(name_or_path)) {
    fail_usage("preset '{}': valid: the path of a JSON file, or one of {}", name_or_path, fmt::join(names, ", "));
  }
  return parse_preset(read_text_file(name_or_path), name_or_path);
}

void overlay(Preset& base, const Preset& top) {
  if (top.scene) base.scene = top.scene;
  if (top.camera) base.camera = top.camera;
  if (!top.techniques.empty()) base.techniques = top.techniques, base.together = top.together;
  if (!top.lights.empty()) base.lights = top.lights;
  base.casts.insert(base.casts.end(), top.casts.begin(), top.casts.end());
  if (top.size) base.size = top.size;
  if (top.samples) base.samples = top.samples;
  base.set.insert(base.set.end(), top.set.begin(), top.set.end());
}

std::string preset_text(const Preset& preset) {
  nlohmann::ordered_json object;
  if (!preset.description.empty()) object["description"] = preset.description;
  if (!preset.source.empty()) object["source"] = preset.source;
  if (preset.scene) object["scene"] = *preset.scene;
  if (!preset.techniques.empty()) object[preset.together ? "technique" : "techniques"] = preset.techniques;
  if (!preset.lights.empty()) object["lights"] = preset.lights;
  if (!preset.casts.empty()) object["casts"] = preset.casts;
  if (preset.camera) object["camera"] = *preset.camera;
  if (preset.size) object["size"] = {preset.size->x, preset.size->y};
  if (preset.samples) {
    if (preset.samples->at_most) {
      object["samples"] = fmt::format("up to {}", preset.samples->count);
    } else {
      object["samples"] = preset.samples->count;
    }
  }
  std::map<std::string, std::string> set;
  for (const auto& [key, value] : preset.set) set[key] = value;
  for (const auto& [key, value] : set) object["set"][key] = value_of(value);
  return object.dump(2) + "\n";
}

}  // namespace gnomon
