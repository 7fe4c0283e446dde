#include "lab/path_file.h"

#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "lab/plan/fields.h"

namespace gnomon {
namespace {

vec3 read_point(const Fields& fields, const char* key) {
  if (!fields.has(key)) fail_usage("{}: no key '{}'; it is needed", fields.where(), key);
  const nlohmann::json& value = fields.at(key);
  const auto is_number = [](const nlohmann::json& item) { return item.is_number() && std::isfinite(item.get<float>()); };
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), is_number)) {
    fields.fail_value(key, "[x, y, z] in metres");
  }
  return {value[0].get<float>(), value[1].get<float>(), value[2].get<float>()};
}

// The shortest text that reads as the same float, as a number.
nlohmann::json number(float value) { return nlohmann::json::parse(fmt::format("{}", value)); }
nlohmann::json point(const vec3& value) { return {number(value.x), number(value.y), number(value.z)}; }

}  // namespace

CameraPath parse_camera_path(std::string_view json, const std::string& where) {
  const nlohmann::json document = parse_plan(json, where);
  const Fields fields(document, where, {"name", "keys"});
  CameraPath path{fields.required_text("name"), {}};
  if (!fields.has("keys")) fail_usage("{}: no key 'keys'; it is needed", where);
  if (!fields.at("keys").is_array() || fields.at("keys").size() < 2) fail_usage("{}: 'keys': valid: a list of two keys or more", where);
  for (const nlohmann::json& item : fields.at("keys")) {
    const Fields key(item, fmt::format("{}: keys[{}]", where, path.keys.size()), {"time", "eye", "target"});
    const double earlier_s = path.keys.empty() ? 0.0 : path.keys.back().time_s;
    const auto time_s = key.number("time");
    if (!time_s) fail_usage("{}: no key 'time'; it is needed", key.where());
    if (path.keys.empty() ? *time_s != 0.0 : !(*time_s > earlier_s)) key.fail_value("time", "seconds: 0 of the first key, then rising");
    path.keys.push_back({*time_s, read_point(key, "eye"), read_point(key, "target")});
    if (path.keys.back().eye == path.keys.back().target) key.fail_value("target", "another point than the eye");
  }
  return path;
}

CameraPath read_camera_path(const std::filesystem::path& path) { return parse_camera_path(read_text_file(path), path.string()); }

std::string camera_path_text(const CameraPath& path) {
  nlohmann::ordered_json object;
  object["name"] = path.name;
  std::string lines;
  for (const CameraKey& key : path.keys) {
    // A key a line: files of long walks stay readable.
    lines += fmt::format("{}    {{\"time\": {}, \"eye\": {}, \"target\": {}}}", lines.empty() ? "" : ",\n", key.time_s, point(key.eye).dump(),
                         point(key.target).dump());
  }
  return fmt::format("{{\n  \"name\": {},\n  \"keys\": [\n{}\n  ]\n}}\n", object["name"].dump(), lines);
}

}  // namespace gnomon
