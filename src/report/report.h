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

// Writes `output` (default: report.html in the first folder) from the results of all folders.
void write_report(std::span<const std::filesystem::path> folders, const std::filesystem::path& output);

// The same results as a flat table, one row per line, for spreadsheets.
void write_csv(std::span<const std::filesystem::path> folders, const std::filesystem::path& output);

// The aligned table that `compare` prints on stdout.
std::string text_table(std::span<const nlohmann::json> results);

// The tables that `bench` prints: times of the runs, counters of those that ask for it, then the rows of their suite beside
// what was published and the goals.
std::string bench_table(std::span<const nlohmann::json> results);

}  // namespace gnomon
