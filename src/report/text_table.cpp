// The aligned table for a terminal: one block per group, columns that nothing fills are left out.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/visible_text.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;

struct Column {
  const char* title;
  const char* pointer;
  double scale;
  enum Style { error, percent, time, mebibytes } style;
};

constexpr Column k_columns[] = {
    {"mae", "/visibility/hard/mae", 1, Column::error},
    {"false shadow %", "/visibility/hard/false_shadow/area", 100, Column::percent},
    {"false light %", "/visibility/hard/false_light/area", 100, Column::percent},
    {"area mae", "/visibility/area/mae", 1, Column::error},
    {"build ms", "/gpu_ms/build", 1, Column::time},
    {"resolve ms", "/gpu_ms/resolve", 1, Column::time},
    {"total ms", "/gpu_ms/total", 1, Column::time},
    {"MiB", "/memory_bytes", 1.0 / (1 << 20), Column::mebibytes},
};

size_t width_of(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// Digits are chosen for the column, not for the number: figures below each other keep their points aligned.
int digits_of(const Column& column, std::span<const json> lines) {
  if (column.style == Column::error) return 4;
  if (column.style == Column::percent) return 2;
  if (column.style == Column::mebibytes) return 1;
  double largest = 0;
  for (const json& line : lines) largest = std::max(largest, number_at(line, column.pointer).value_or(0) * column.scale);
  return largest >= 1000 ? 1 : largest >= 100 ? 2 : 3;
}

std::string cell(const json& line, const Column& column, int digits) {
  const auto value = number_at(line, column.pointer);
  return value ? fmt::format("{:.{}f}", *value * column.scale, digits) : "-";
}

struct Row {
  std::string label;
  std::vector<std::string> cells;
  std::string reason;  // of an unavailable technique, in place of the cells
};

std::vector<Row> rows_of(const ResultGroup& group, std::span<const json> lines, std::span<const Column> columns,
                         std::span<const int> digits) {
  std::vector<Row> rows;
  for (size_t i = 0; i < group.rows.size(); ++i) {
    const json& line = lines[group.rows[i]];
    Row row{visible_line(group.labels[i]), {}, {}};
    if (is_available(line)) {
      for (size_t c = 0; c < columns.size(); ++c) row.cells.push_back(cell(line, columns[c], digits[c]));
    } else {
      const std::string reason = visible_line(text_at(line, "/reason"));
      row.reason = "unavailable: " + (reason.empty() ? "no reason given" : reason);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : ", ") + visible_line(part);
  return text;
}

}  // namespace

std::string text_table(std::span<const json> results) {
  if (results.empty()) return "no results\n";
  std::vector<Column> columns;
  for (const Column& column : k_columns) {
    const bool is_filled = std::any_of(results.begin(), results.end(),
                                       [&](const json& line) { return number_at(line, column.pointer).has_value(); });
    const bool is_optional = std::string_view(column.title) == "area mae";
    if (is_filled || !is_optional) columns.push_back(column);
  }

  const auto groups = group_results(results);
  std::vector<std::vector<Row>> blocks;
  size_t label_width = width_of("technique");
  std::vector<size_t> widths;
  std::vector<int> digits;
  for (const Column& column : columns) {
    widths.push_back(width_of(column.title));
    digits.push_back(digits_of(column, results));
  }
  for (const auto& group : groups) {
    for (const Row& row : blocks.emplace_back(rows_of(group, results, columns, digits))) {
      label_width = std::max(label_width, width_of(row.label));
      for (size_t i = 0; i < row.cells.size(); ++i) widths[i] = std::max(widths[i], width_of(row.cells[i]));
    }
  }

  const auto padded = [&](const std::string& label) { return label + std::string(label_width - width_of(label), ' '); };
  std::string text = padded("technique");
  for (size_t i = 0; i < columns.size(); ++i) text += fmt::format("  {:>{}}", columns[i].title, widths[i]);
  text += "\n";
  for (size_t block = 0; block < blocks.size(); ++block) {
    if (groups.size() > 1) text += fmt::format("\n{}\n", joined(groups[block].title));
    for (const Row& row : blocks[block]) {
      text += padded(row.label);
      for (size_t i = 0; i < row.cells.size(); ++i) text += fmt::format("  {:>{}}", row.cells[i], widths[i]);
      if (!row.reason.empty()) text += "  " + row.reason;
      text += "\n";
    }
  }
  return text;
}

}  // namespace gnomon
