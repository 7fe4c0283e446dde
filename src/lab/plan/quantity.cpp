// Numbers and ratios.
#include "lab/plan/quantity.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gnomon {
namespace {

using nlohmann::json;

struct Simple {
  std::string_view name;
  const char* pointer;
};
constexpr Simple k_simple[] = {{"frame", "/timing/frame_ms"},  {"technique", "/gpu_ms/total"},  {"build", "/gpu_ms/build"},
                               {"resolve", "/gpu_ms/resolve"}, {"record", "/timing/record_ms"}, {"memory", "/memory_bytes"}};

struct OfPasses {
  std::string_view prefix;
  const char* key;
};
constexpr OfPasses k_of_passes[] = {{"ms:", "median_ms"}, {"draws:", "draws"}, {"triangles:", "triangles"}};

std::optional<double> number_at(const json& line, const char* pointer) {
  const json::json_pointer path(pointer);
  if (!line.contains(path) || !line.at(path).is_number()) return std::nullopt;
  return line.at(path).get<double>();
}

std::optional<double> sum_of_passes(const json& line, std::string_view text, const char* key) {
  if (!line.contains("passes")) return std::nullopt;
  std::optional<double> sum;
  for (const json& pass : line["passes"]) {
    if (pass["name"].get_ref<const std::string&>().find(text) != std::string::npos)
      sum = sum.value_or(0.0) + pass[key].get<double>();
  }
  return sum;
}

const json* line_of(const std::vector<json>& lines, const std::string& run) {
  const auto found =
      std::find_if(lines.begin(), lines.end(), [&](const json& line) { return line.at("bench").at("run") == run; });
  return found == lines.end() ? nullptr : &*found;
}

json or_null(std::optional<double> value) { return value && std::isfinite(*value) ? json(*value) : json(); }

// Bits of masks: equal, different, or unknown where one is missing.
json masks_are_equal(const SuiteRow& row, const std::vector<json>& lines) {
  std::vector<std::string> hashes;
  for (const std::string& run : row.runs) {
    const json* line = line_of(lines, run);
    if (!line || !(*line)["bench"].contains("mask_hash")) return {};
    hashes.push_back((*line)["bench"]["mask_hash"]);
  }
  return std::all_of(hashes.begin(), hashes.end(), [&](const std::string& hash) { return hash == hashes.front(); });
}

}  // namespace

bool is_quantity(std::string_view of) {
  return std::any_of(std::begin(k_simple), std::end(k_simple), [&](const Simple& simple) { return simple.name == of; }) ||
         std::any_of(std::begin(k_of_passes), std::end(k_of_passes),
                     [&](const OfPasses& kind) { return of.starts_with(kind.prefix) && of.size() > kind.prefix.size(); });
}

std::string_view unit_of(std::string_view of) {
  if (of == "memory") return "byte";
  return of.starts_with("draws:") || of.starts_with("triangles:") ? "" : "ms";
}

std::optional<double> quantity(const json& line, std::string_view of) {
  for (const Simple& simple : k_simple) {
    if (simple.name == of) return number_at(line, simple.pointer);
  }
  for (const OfPasses& kind : k_of_passes) {
    if (of.starts_with(kind.prefix)) return sum_of_passes(line, of.substr(kind.prefix.size()), kind.key);
  }
  return std::nullopt;
}

json evaluate_row(const SuiteRow& row, const std::vector<json>& lines) {
  json result = {{"name", row.name}, {"source", row.source}, {"runs", row.runs}};
  if (row.kind == SuiteRow::Kind::masks) {
    result["kind"] = "masks";
    result["met"] = masks_are_equal(row, lines);
    return result;
  }
  const auto value_of = [&](const std::string& run, std::string_view of) -> std::optional<double> {
    const json* line = line_of(lines, run);
    return line ? quantity(*line, of) : std::nullopt;
  };
  const auto ratio_of = [&](std::string_view of, std::string_view denominator_of) -> std::optional<double> {
    const auto a = value_of(row.runs[0], of), b = value_of(row.runs[1], denominator_of);
    return a && b && *b > 0.0 ? std::optional(*a / *b) : std::nullopt;
  };
  const bool is_ratio = row.kind == SuiteRow::Kind::ratio;
  result["kind"] = is_ratio ? "ratio" : "figure";
  result["of"] = row.of;
  result["unit"] = unit_of(row.of);
  result["numerator"] = or_null(value_of(row.runs[0], row.of));
  std::optional<double> value = value_of(row.runs[0], row.of);
  if (is_ratio) {
    result["denominator_of"] = row.denominator_of;
    result["denominator"] = or_null(value_of(row.runs[1], row.denominator_of));
    value = ratio_of(row.of, row.denominator_of);
    // A technique that is twice as dear may be hardly felt in the frame: the other view of the same ratio.
    if (row.of == row.denominator_of && (row.of == "frame" || row.of == "technique")) {
      const char* other = row.of == "frame" ? "technique" : "frame";
      result["also"] = {{"of", other}, {"value", or_null(ratio_of(other, other))}};
    }
  }
  result["value"] = or_null(value);
  result["published"] = row.published ? json({row.published->first, row.published->second}) : json();
  result["goal"] = or_null(row.goal);
  result["met"] = row.goal && value ? json(*value <= *row.goal) : json();
  return result;
}

}  // namespace gnomon
