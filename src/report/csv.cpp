// Results as CSV (RFC 4180): full precision, one column per setting that any line has.
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;

struct Column {
  const char* title;
  const char* pointer;
};

constexpr Column k_columns[] = {
    {"scene", "/scene/name"},
    {"scene_hash", "/scene/hash"},
    {"triangles", "/scene/triangles"},
    {"camera", "/camera/name"},
    {"width", "/size/0"},
    {"height", "/size/1"},
    {"samples", "/samples"},
    {"device", "/device/name"},
    {"driver", "/device/driver"},
    {"driver_version", "/device/driver_version"},
    {"gnomon_version", "/gnomon/version"},
    {"gnomon_commit", "/gnomon/commit"},
    {"technique", "/technique"},
    {"status", "/status"},
    {"reason", "/reason"},
    {"hard_mae", "/visibility/hard/mae"},
    {"hard_rmse", "/visibility/hard/rmse"},
    {"hard_bias", "/visibility/hard/bias"},
    {"hard_false_shadow_area", "/visibility/hard/false_shadow/area"},
    {"hard_false_shadow_severity", "/visibility/hard/false_shadow/severity"},
    {"hard_false_light_area", "/visibility/hard/false_light/area"},
    {"hard_false_light_severity", "/visibility/hard/false_light/severity"},
    {"hard_receivers", "/visibility/hard/receivers"},
    {"area_mae", "/visibility/area/mae"},
    {"area_rmse", "/visibility/area/rmse"},
    {"area_bias", "/visibility/area/bias"},
    {"area_false_shadow_area", "/visibility/area/false_shadow/area"},
    {"area_false_shadow_severity", "/visibility/area/false_shadow/severity"},
    {"area_false_light_area", "/visibility/area/false_light/area"},
    {"area_false_light_severity", "/visibility/area/false_light/severity"},
    {"area_receivers", "/visibility/area/receivers"},
    {"pixel_mae", "/visibility/pixel/mae"},
    {"pixel_rmse", "/visibility/pixel/rmse"},
    {"pixel_bias", "/visibility/pixel/bias"},
    {"pixel_false_shadow_area", "/visibility/pixel/false_shadow/area"},
    {"pixel_false_shadow_severity", "/visibility/pixel/false_shadow/severity"},
    {"pixel_false_light_area", "/visibility/pixel/false_light/area"},
    {"pixel_false_light_severity", "/visibility/pixel/false_light/severity"},
    {"pixel_receivers", "/visibility/pixel/receivers"},
    {"image_rmse", "/image/rmse"},
    {"image_psnr", "/image/psnr"},
    {"build_ms", "/gpu_ms/build"},
    {"resolve_ms", "/gpu_ms/resolve"},
    {"total_ms", "/gpu_ms/total"},
    {"frame_ms", "/timing/frame_ms"},
    {"sum_of_passes_ms", "/timing/sum_of_passes_ms"},
    {"timing_mode", "/timing/mode"},
    {"timing_clock", "/timing/clock"},
    {"memory_bytes", "/memory_bytes"},
    {"hard_reference", "/reference/hard/kind"},
    {"hard_reference_samples", "/reference/hard/samples"},
    {"hard_reference_confidence", "/reference/hard/confidence"},
    {"area_reference", "/reference/area/kind"},
    {"area_reference_samples", "/reference/area/samples"},
    {"area_reference_confidence", "/reference/area/confidence"},
    {"pixel_reference", "/reference/pixel/kind"},
    {"pixel_reference_samples", "/reference/pixel/samples"},
    {"pixel_reference_rays", "/reference/pixel/rays"},
    {"pixel_reference_confidence", "/reference/pixel/confidence"},
    {"pixel_uncovered", "/reference/pixel/uncovered"},
    {"command", "/command"},
};

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string cell(const json& line, const char* pointer) {
  const json::json_pointer path(pointer);
  if (!line.contains(path)) return {};
  const json& value = line.at(path);
  if (value.is_null()) return {};
  return quoted(value.is_string() ? value.get<std::string>() : value.dump());
}

}  // namespace

void write_csv(std::span<const std::filesystem::path> folders, const std::filesystem::path& output) {
  const ResultSet set = read_result_folders(folders);
  std::set<std::string> settings, artefacts;
  for (const json& line : set.lines) {
    for (const auto& [name, value] : flat_settings(line)) settings.insert(name);
    if (!line.contains("artefacts") || !line["artefacts"].is_object()) continue;
    for (const auto& [name, value] : line["artefacts"].items()) artefacts.insert(name);
  }

  std::string text;
  for (const Column& column : k_columns) text += (text.empty() ? "" : ",") + std::string(column.title);
  for (const auto& name : artefacts) text += "," + quoted("artefacts." + name);
  for (const auto& name : settings) text += "," + quoted(name);
  text += "\n";
  for (const json& line : set.lines) {
    std::string row;
    for (const Column& column : k_columns) {
      row += (&column == k_columns ? "" : ",") + cell(line, column.pointer);
    }
    const json none = json::object();
    const json& scores = line.contains("artefacts") && line["artefacts"].is_object() ? line["artefacts"] : none;
    for (const auto& name : artefacts) row += "," + (scores.contains(name) ? quoted(scores[name].dump()) : "");
    const auto values = flat_settings(line);
    for (const auto& name : settings) {
      const auto found = values.find(name);
      row += "," + (found == values.end() ? std::string() : quoted(found->second));
    }
    text += row + "\n";
  }
  write_file(output, text);
}

}  // namespace gnomon
