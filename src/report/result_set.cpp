// Access, groups and labels.
#include "report/result_set.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace gnomon {
namespace {

using nlohmann::json;

const json* find(const json& line, const char* pointer) {
  const json::json_pointer path(pointer);
  return line.contains(path) ? &line.at(path) : nullptr;
}

void flatten(const json& value, const std::string& name, std::map<std::string, std::string>& flat) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) flatten(item, name.empty() ? key : name + "." + key, flat);
  } else {
    flat[name] = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

std::string light_names(const json& line) {
  std::string names;
  const json* lights = find(line, "/lights");
  if (!lights || !lights->is_array()) return names;
  for (const json& light : *lights) {
    const std::string name = text_at(light, "/name");
    names += (names.empty() ? "" : ", ") + (name.empty() ? "unnamed light" : name);
  }
  return names;
}

// Two lines may be compared where all of this is equal.
std::string group_key(const json& line) {
  json key = json::array();
  for (const char* pointer : {"/scene/name", "/scene/hash", "/camera", "/lights", "/size", "/samples", "/device/name",
                              "/device/driver", "/device/driver_version"}) {
    const json* value = find(line, pointer);
    key.push_back(value ? *value : json());
  }
  return key.dump(-1, ' ', false, json::error_handler_t::replace);
}

bool differ(std::span<const json> lines, std::string (*text)(const json&)) {
  for (const json& line : lines) {
    if (text(line) != text(lines.front())) return true;
  }
  return false;
}

std::string device_name(const json& line) { return text_at(line, "/device/name"); }

std::vector<std::string> group_title(const json& line, bool with_lights, bool with_device) {
  std::vector<std::string> title = {text_at(line, "/scene/name")};
  if (const auto camera = text_at(line, "/camera/name"); !camera.empty()) title.push_back("camera " + camera);
  const auto width = number_at(line, "/size/0"), height = number_at(line, "/size/1"), samples = number_at(line, "/samples");
  if (width && height) title.push_back(fmt::format("{} × {}", *width, *height));
  if (samples) title.push_back(fmt::format("{} sample{}", *samples, *samples == 1 ? "" : "s"));
  if (with_lights) title.push_back(light_names(line));
  if (with_device) title.push_back(device_name(line));
  return title;
}

// The technique, and behind it the settings whose values differ among the rows of the same technique.
std::vector<std::string> row_labels(std::span<const json> lines, const std::vector<size_t>& rows) {
  std::map<std::string, std::map<std::string, std::set<std::string>>> values;  // technique -> setting -> values seen
  std::map<std::string, size_t> count;
  for (const size_t row : rows) {
    const std::string technique = text_at(lines[row], "/technique");
    ++count[technique];
    for (const auto& [name, value] : flat_settings(lines[row])) values[technique][name].insert(value);
  }
  std::vector<std::string> labels;
  std::map<std::string, int> used;
  for (const size_t row : rows) {
    const std::string technique = text_at(lines[row], "/technique");
    std::string label = technique;
    if (count[technique] > 1) {
      for (const auto& [name, value] : flat_settings(lines[row])) {
        if (values[technique][name].size() > 1) label += " " + name + "=" + value;
      }
    }
    const int repeat = ++used[label];
    labels.push_back(repeat == 1 ? label : fmt::format("{} ({})", label, repeat));
  }
  return labels;
}

}  // namespace

std::optional<double> number_at(const json& line, const char* pointer) {
  const json* value = find(line, pointer);
  if (!value || !value->is_number() || !std::isfinite(value->get<double>())) return std::nullopt;
  return value->get<double>();
}

std::string text_at(const json& line, const char* pointer) {
  const json* value = find(line, pointer);
  return value && value->is_string() ? value->get<std::string>() : std::string();
}

bool is_available(const json& line) { return text_at(line, "/status") != "unavailable"; }

std::map<std::string, std::string> flat_settings(const json& line) {
  std::map<std::string, std::string> flat;
  if (const json* settings = find(line, "/settings"); settings && settings->is_object()) flatten(*settings, "", flat);
  return flat;
}

std::vector<ResultGroup> group_results(std::span<const json> lines) {
  const bool with_lights = differ(lines, light_names), with_device = differ(lines, device_name);
  std::vector<ResultGroup> groups;
  std::map<std::string, size_t> index;
  std::map<std::vector<std::string>, int> used;
  for (size_t row = 0; row < lines.size(); ++row) {
    const auto [found, is_new] = index.try_emplace(group_key(lines[row]), groups.size());
    if (is_new) {
      auto& group = groups.emplace_back();
      group.title = group_title(lines[row], with_lights, with_device);
      // Lights or cameras of one name may still differ in their values.
      if (const int repeat = ++used[group.title]; repeat > 1) group.title.push_back(fmt::format("({})", repeat));
    }
    groups[found->second].rows.push_back(row);
  }
  for (auto& group : groups) group.labels = row_labels(lines, group.rows);
  return groups;
}

}  // namespace gnomon
