#include "lab/view/path_file.h"

#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "lab/plan/fields.h"
#include "lab/view/light_text.h"

namespace gnomon {
namespace {

// Nearer to opposite, no great circle between the two is the right one.
constexpr double k_widest_turn_degrees = 179.0;

double required_number(const Fields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) fail_usage("{}: no key '{}'; it is needed", fields.where(), key);
  return *value;
}

vec3 read_vec3(const Fields& fields, const char* key, const char* valid) {
  if (!fields.has(key)) fail_usage("{}: no key '{}'; it is needed", fields.where(), key);
  const nlohmann::json& value = fields.at(key);
  const auto is_number = [](const nlohmann::json& item) { return item.is_number() && std::isfinite(item.get<float>()); };
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), is_number))
    fields.fail_value(key, valid);
  return {value[0].get<float>(), value[1].get<float>(), value[2].get<float>()};
}

float read_number(const Fields& fields, const char* key, double least, double most, const char* valid) {
  const double value = required_number(fields, key);
  if (!(value >= least && value <= most)) fields.fail_value(key, valid);
  return static_cast<float>(value);
}

CameraKey read_camera_key(const Fields& fields, double time_s) {
  const CameraKey key{time_s, read_vec3(fields, "eye", "[x, y, z] in metres"),
                      read_vec3(fields, "target", "[x, y, z] in metres")};
  if (key.eye == key.target) fields.fail_value("target", "another point than the eye");
  return key;
}

SunKey read_sun_key(const Fields& fields, double time_s) {
  const float azimuth = read_number(fields, "azimuth", -360.0, 360.0, "-360 to 360 [degree]");
  const float elevation = read_number(fields, "elevation", -90.0, 90.0, "-90 to 90 [degree]");
  const vec3 colour = read_vec3(fields, "colour", "[red, green, blue], linear");
  if (glm::any(glm::lessThan(colour, vec3(0.0f)))) fields.fail_value("colour", "[red, green, blue], none below 0");
  return {time_s, {sun_direction(azimuth, elevation), colour, read_number(fields, "intensity", 0.0, 1e9, "0 to 1e9 [lux]")}};
}

// The list of keys that `name` holds; each has a time and what `read` reads of it.
template <class Key, class Read>
std::vector<Key> read_keys(const Fields& fields, const char* name, std::initializer_list<std::string_view> valid,
                           const Read& read) {
  const nlohmann::json& list = fields.at(name);
  if (!list.is_array() || list.size() < 2) fail_usage("{}: '{}': valid: a list of two keys or more", fields.where(), name);
  std::vector<Key> keys;
  for (const nlohmann::json& item : list) {
    const Fields key(item, fmt::format("{}: {}[{}]", fields.where(), name, keys.size()), valid);
    const double time_s = required_number(key, "time");
    if (keys.empty() ? time_s != 0.0 : !(time_s > keys.back().time_s))
      key.fail_value("time", "seconds: 0 of the first key, then rising");
    keys.push_back(read(key, time_s));
  }
  return keys;
}

void check_turns(const std::vector<SunKey>& keys, const std::string& where) {
  for (size_t i = 1; i < keys.size(); ++i) {
    const double cosine = glm::dot(glm::dvec3(keys[i - 1].state.direction), glm::dvec3(keys[i].state.direction));
    if (cosine > std::cos(k_widest_turn_degrees * 3.14159265358979323846 / 180.0)) continue;
    fail_usage("{}: sun[{}]: opposite the sun of the key before, so the way is open; valid: a key between the two", where, i);
  }
}

// The shortest text that reads as the same float, as a number.
nlohmann::json number(float value) { return nlohmann::json::parse(fmt::format("{}", value)); }
nlohmann::json list(const vec3& value) { return {number(value.x), number(value.y), number(value.z)}; }

std::string key_text(const CameraKey& key) {
  return fmt::format("{{\"time\": {}, \"eye\": {}, \"target\": {}}}", key.time_s, list(key.eye).dump(),
                     list(key.target).dump());
}

std::string key_text(const SunKey& key) {
  const glm::dvec2 angles = sun_angles(key.state.direction);
  return fmt::format("{{\"time\": {}, \"azimuth\": {:.9g}, \"elevation\": {:.9g}, \"colour\": {}, \"intensity\": {}}}",
                     key.time_s, angles.x, angles.y, list(key.state.colour).dump(), key.state.intensity);
}

// A key a line: files of long walks stay readable.
template <class Key>
std::string keys_text(const char* name, const std::vector<Key>& keys) {
  std::string lines;
  for (const Key& key : keys) lines += (lines.empty() ? "    " : ",\n    ") + key_text(key);
  return fmt::format(",\n  \"{}\": [\n{}\n  ]", name, lines);
}

}  // namespace

Recording parse_recording(std::string_view json, const std::string& where) {
  const nlohmann::json document = parse_plan(json, where);
  const Fields fields(document, where, {"name", "keys", "sun"});
  const std::string name = fields.required_text("name");
  Recording recording;
  if (fields.has("keys"))
    recording.camera = {name, read_keys<CameraKey>(fields, "keys", {"time", "eye", "target"}, read_camera_key)};
  if (fields.has("sun")) {
    recording.sun = {name,
                     read_keys<SunKey>(fields, "sun", {"time", "azimuth", "elevation", "colour", "intensity"}, read_sun_key)};
    check_turns(recording.sun->keys, where);
  }
  if (!recording.camera && !recording.sun)
    fail_usage("{}: neither 'keys' (of a camera) nor 'sun'; one of them is needed", where);
  return recording;
}

std::string recording_text(const Recording& recording) {
  GNOMON_ASSERT(recording.camera || recording.sun);
  std::string text = "{\n  \"name\": " + nlohmann::json(recording.camera ? recording.camera->name : recording.sun->name).dump();
  if (recording.camera) text += keys_text("keys", recording.camera->keys);
  if (recording.sun) text += keys_text("sun", recording.sun->keys);
  return text + "\n}\n";
}

Recording read_recording(const std::filesystem::path& path) { return parse_recording(read_text_file(path), path.string()); }

CameraPath read_camera_path(const std::filesystem::path& path) {
  auto recording = read_recording(path);
  if (!recording.camera)
    fail_usage("{}: no key 'keys': it moves a sun, and no camera; valid: --sun-path {}", path.string(), path.string());
  return *std::move(recording.camera);
}

RecordedSun read_sun_path(const std::filesystem::path& path) {
  auto recording = read_recording(path);
  if (!recording.sun)
    fail_usage("{}: no key 'sun': it moves a camera, and no sun; valid: --path {}", path.string(), path.string());
  return *std::move(recording.sun);
}

}  // namespace gnomon
