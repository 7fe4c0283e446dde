// A file of one line for each device: "device|driver version|path".
#include "frame/casters/layering_choice.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "base/user_folder.h"

namespace gnomon {
namespace {

std::filesystem::path cache_file() {
  const auto folder = user_folder(UserFolder::cache);
  return folder.empty() ? folder : folder / "layering";
}

std::string key_of(const DeviceInfo& device) { return device.name + "|" + device.driver_version; }

std::map<std::string, std::string> read_cache() {
  std::map<std::string, std::string> lines;
  std::ifstream file(cache_file());
  for (std::string line; std::getline(file, line);) {
    if (const size_t bar = line.rfind('|'); bar != line.npos) lines[line.substr(0, bar)] = line.substr(bar + 1);
  }
  return lines;
}

// Read once: a process that measures beside this one must not change how its next map is drawn.
std::map<std::string, std::string>& known_paths() {
  static std::map<std::string, std::string> lines = read_cache();
  return lines;
}

}  // namespace

std::optional<LayeringPath> measured_layering_path(const DeviceInfo& device) {
  const auto& lines = known_paths();
  const auto found = lines.find(key_of(device));
  if (found == lines.end()) return std::nullopt;
  for (const auto path :
       {LayeringPath::per_layer, LayeringPath::vertex_layer, LayeringPath::geometry, LayeringPath::multiview}) {
    if (layering_path_name(path) == found->second && layering_path_missing(device, path).empty()) return path;
  }
  return std::nullopt;
}

void store_layering_path(const DeviceInfo& device, LayeringPath path) {
  known_paths()[key_of(device)] = layering_path_name(path);
  auto lines = read_cache();
  lines[key_of(device)] = layering_path_name(path);
  std::string text;
  for (const auto& [key, value] : lines) text += key + '|' + value + '\n';
  try {
    make_folder(cache_file().parent_path());
    write_file(cache_file(), text);
  } catch (const Error&) {
    // A cache that cannot be written is none: the next run measures again.
  }
}

LayeringPath fastest_layering_path(const DeviceInfo& device) {
  return measured_layering_path(device).value_or(LayeringPath::per_layer);
}

}  // namespace gnomon
