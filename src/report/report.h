// results.jsonl and pictures -> one self-contained HTML page, and CSV. Reads results only (docs/results_format.md).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

// All lines of DIR/results.jsonl. Throws Error with file and line number for what is not a result.
std::vector<nlohmann::json> read_results(const std::filesystem::path& folder);

// Errors are measured against up to three truths (docs/measuring.md): "pixel", "area", "hard", the first of which tables and
// charts go by where it was measured. `against` names another one to go by; where a group lacks it, it goes by the first that
// it has.
inline constexpr const char* k_truth_names[] = {"pixel", "area", "hard"};

// Writes `output` (default: report.html in the first folder) from the results of all folders.
void write_report(std::span<const std::filesystem::path> folders, const std::filesystem::path& output,
                  const std::string& against = k_truth_names[0]);

// The same results as a flat table, one row per line, for spreadsheets.
void write_csv(std::span<const std::filesystem::path> folders, const std::filesystem::path& output);

// The aligned table that `compare` prints on stdout, the least error of each group first.
std::string text_table(std::span<const nlohmann::json> results, const std::string& against = k_truth_names[0]);

// The tables that `bench` prints: times of the runs, counters of those that ask for it, then the rows of their suite beside
// what was published and the goals.
std::string bench_table(std::span<const nlohmann::json> results);

}  // namespace gnomon
