// What table, CSV and page share: lines with their origin, access that tolerates absence, groups and labels of rows.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

// Where a line stands: its pictures are relative to the folder, errors name file and line.
struct ResultOrigin {
  std::filesystem::path folder;
  size_t line = 0;
  std::string text() const;  // "out/results.jsonl:3"
};

struct ResultSet {
  std::vector<nlohmann::json> lines;
  std::vector<ResultOrigin> origins;  // one per line
};

// All lines of all folders, checked. Throws Error for no folder, and as read_results.
ResultSet read_result_folders(std::span<const std::filesystem::path> folders);

// Absent, null and of another type are all "not there": a line may lack what its run did not measure.
std::optional<double> number_at(const nlohmann::json& line, const char* pointer);
std::string text_at(const nlohmann::json& line, const char* pointer);
bool is_available(const nlohmann::json& line);

// {"single": {"size": 2048}} -> single.size: "2048".
std::map<std::string, std::string> flat_settings(const nlohmann::json& line);

// Rows that may be compared with each other: same scene, camera, lights, size, samples, device.
struct ResultGroup {
  std::vector<std::string> title;   // "courtyard", "camera default", "800 × 600", "1 sample"
  std::vector<size_t> rows;         // indices of lines, in their order
  std::vector<std::string> labels;  // one per row: technique, and the settings in which rows of one technique differ
};

// In the order of their first lines.
std::vector<ResultGroup> group_results(std::span<const nlohmann::json> lines);

}  // namespace gnomon
