// The tables of a bench for a terminal.
#include <algorithm>

#include "base/error.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;

using Cells = std::vector<std::string>;

size_t width_of(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// First column to the left, the rest to the right.
std::string aligned(const std::vector<Cells>& rows) {
  std::vector<size_t> widths;
  for (const Cells& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const Cells& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - width_of(row[i]), ' ');
      text += i == 0 ? row[i] + blanks : "  " + blanks + row[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

// Three significant digits, never an exponent; "-" for what there is not.
std::string number(std::optional<double> value) {
  if (!value) return "-";
  const double v = *value;
  return fmt::format("{:.{}f}", v, v == 0.0 || v >= 100.0 ? 0 : v >= 10.0 ? 1 : v >= 1.0 ? 2 : 3);
}

std::string count(std::optional<double> value) { return value ? fmt::format("{:.0f}", *value) : "-"; }

std::string text_of(const json& line, const char* pointer) {
  std::string text = text_at(line, pointer);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

bool is_bench(const json& line) { return line.contains("bench") && line["bench"].is_object(); }

const json& list_at(const json& line, const char* pointer) {
  static const json none = json::array();
  const json::json_pointer path(pointer);
  return line.contains(path) && line.at(path).is_array() ? line.at(path) : none;
}

std::string times(std::span<const json> lines) {
  std::vector<Cells> rows = {
      {"run", "technique", "build ms", "resolve ms", "technique ms", "frame ms", "CPU ms", "draws", "triangles"}};
  std::string reasons;
  for (const json& line : lines) {
    if (!is_bench(line)) continue;
    if (!is_available(line)) {
      rows.push_back({text_of(line, "/bench/run"), text_of(line, "/technique"), "unavailable"});
      reasons += fmt::format("{}: {}\n", text_of(line, "/bench/run"), text_of(line, "/reason"));
      continue;
    }
    double draws = 0.0, triangles = 0.0;
    for (const json& pass : list_at(line, "/passes")) {
      if (text_at(pass, "/stage") != "build") continue;
      draws += number_at(pass, "/draws").value_or(0.0), triangles += number_at(pass, "/triangles").value_or(0.0);
    }
    const auto cell = [&](const char* pointer) { return number(number_at(line, pointer)); };
    rows.push_back({text_of(line, "/bench/run"), text_of(line, "/technique"), cell("/gpu_ms/build"), cell("/gpu_ms/resolve"),
                    cell("/gpu_ms/total"), cell("/timing/frame_ms"), cell("/timing/record_ms"), count(draws),
                    count(triangles)});
  }
  return aligned(rows) + reasons;
}

std::string counters(std::span<const json> lines) {
  std::vector<Cells> rows = {{"drawn into maps", "pass", "draws", "triangles"}};
  for (const json& line : lines) {
    if (!is_bench(line) || !line["bench"].value("counters", false)) continue;
    for (const json& pass : list_at(line, "/passes")) {
      if (text_at(pass, "/stage") != "build" || number_at(pass, "/draws").value_or(0.0) == 0.0) continue;
      rows.push_back({text_of(line, "/bench/run"), text_of(pass, "/name"), count(number_at(pass, "/draws")),
                      count(number_at(pass, "/triangles"))});
    }
  }
  return rows.size() == 1 ? "" : "\n" + aligned(rows);
}

std::string range(const json& row) {
  const auto from = number_at(row, "/published/0"), to = number_at(row, "/published/1");
  if (!from || !to) return "-";
  return *from == *to ? number(from) : number(from) + ".." + number(to);
}

std::string met(const json& row) {
  const json& value = row.value("met", json());
  return value.is_boolean() ? (value.get<bool>() ? "yes" : "NO") : "-";
}

// The same ratio of the frame where the row is of the technique, and the other way round.
std::string also(const json& row) {
  const auto value = number_at(row, "/also/value");
  return value ? fmt::format("{}: {}", text_at(row, "/also/of"), number(value)) : "";
}

// In the order of their suite: a row stands in the line of its first run.
std::vector<const json*> ordered_rows(std::span<const json> lines) {
  std::vector<const json*> rows;
  for (const json& line : lines) {
    for (const json& row : list_at(line, "/bench/rows")) rows.push_back(&row);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const json* a, const json* b) {
    return number_at(*a, "/index").value_or(0.0) < number_at(*b, "/index").value_or(0.0);
  });
  return rows;
}

std::string suite_rows(std::span<const json> lines) {
  std::vector<Cells> rows = {{"row", "of", "measured", "over", "value", "published", "goal <=", "met", "also"}};
  for (const json* found : ordered_rows(lines)) {
    const json& row = *found;
    if (text_at(row, "/kind") == "masks") {
      const std::string equal = row.value("met", json()).is_boolean() ? (row["met"].get<bool>() ? "equal" : "differ") : "-";
      rows.push_back({text_of(row, "/name"), "masks", "-", "-", equal, "-", "equal", met(row), ""});
      continue;
    }
    // Counts keep all their digits.
    const bool is_count = text_at(row, "/unit").empty();
    const auto measured = [&](const char* pointer) {
      return is_count ? count(number_at(row, pointer)) : number(number_at(row, pointer));
    };
    rows.push_back({text_of(row, "/name"), text_of(row, "/of"), measured("/numerator"), measured("/denominator"),
                    number(number_at(row, "/value")), range(row), number(number_at(row, "/goal")), met(row), also(row)});
  }
  return rows.size() == 1 ? "" : "\n" + aligned(rows);
}

}  // namespace

std::string bench_table(std::span<const json> lines) { return times(lines) + counters(lines) + suite_rows(lines); }

}  // namespace gnomon
