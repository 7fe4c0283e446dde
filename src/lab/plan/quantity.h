// What a suite's rows are about: numbers of result lines, and ratios of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "lab/plan/suite.h"

namespace gnomon {

// "frame", "technique" (build + resolve), "build", "resolve" [ms]; "record" (CPU: recording and submitting) [ms]; "memory"
// [byte]; "ms:TEXT", "draws:TEXT", "triangles:TEXT": sums over the passes whose names hold TEXT.
inline constexpr const char* k_valid_quantities =
    "frame, technique, build, resolve, record, memory, ms:PASS, draws:PASS, triangles:PASS";
bool is_quantity(std::string_view of);
std::string_view unit_of(std::string_view quantity);  // "ms", "byte" or ""

// Nothing where the line does not hold it: unavailable, or no pass of that name.
std::optional<double> quantity(const nlohmann::json& line, std::string_view of);

// The rows of a suite with what the lines say, as results.jsonl holds them (docs/results_format.md, `bench.rows`). Lines are
// found by `bench.run`; a value that cannot be had is null.
nlohmann::json evaluate_row(const SuiteRow& row, const std::vector<nlohmann::json>& lines);

}  // namespace gnomon
