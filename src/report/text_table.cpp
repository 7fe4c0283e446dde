// The aligned table for a terminal: one block per group, columns that nothing fills are left out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/visible_text.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;

struct Column {
  std::string title, pointer;
  double scale;
  enum Style { error, percent, time, mebibytes } style;
};

bool is_measured(std::span<const json> results, const std::string& truth) {
  const std::string pointer = "/visibility/" + truth + "/mae";
  return std::any_of(results.begin(), results.end(),
                     [&](const json& line) { return number_at(line, pointer.c_str()).has_value(); });
}

// The truth that a table goes by.
std::string truth_of(std::span<const json> results, const std::string& wanted) {
  if (is_measured(results, wanted)) return wanted;
  const auto found = std::find_if(std::begin(k_truth_names), std::end(k_truth_names),
                                  [&](const char* truth) { return is_measured(results, truth); });
  return found == std::end(k_truth_names) ? wanted : *found;
}

// The scores by the truth that counts, then what the others say; columns of other truths that nothing fills are left out.
std::vector<Column> columns_of(std::span<const json> results, const std::string& truth) {
  const std::string scores = "/visibility/" + truth;
  std::vector<Column> columns = {{truth + " mae", scores + "/mae", 1, Column::error},
                                 {"false shadow %", scores + "/false_shadow/area", 100, Column::percent},
                                 {"false light %", scores + "/false_light/area", 100, Column::percent}};
  for (const std::string other : k_truth_names) {
    if (other != truth && is_measured(results, other))
      columns.push_back({other + " mae", "/visibility/" + other + "/mae", 1, Column::error});
  }
  for (const char* stage : {"build", "resolve", "total"})
    columns.push_back({std::string(stage) + " ms", std::string("/gpu_ms/") + stage, 1, Column::time});
  columns.push_back({"MiB", "/memory_bytes", 1.0 / (1 << 20), Column::mebibytes});
  return columns;
}

size_t width_of(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// Digits are chosen for the column, not for the number: figures below each other keep their points aligned.
int digits_of(const Column& column, std::span<const json> lines) {
  if (column.style == Column::error) return 4;
  if (column.style == Column::percent) return 2;
  if (column.style == Column::mebibytes) return 1;
  double largest = 0;
  for (const json& line : lines)
    largest = std::max(largest, number_at(line, column.pointer.c_str()).value_or(0) * column.scale);
  return largest >= 1000 ? 1 : largest >= 100 ? 2 : 3;
}

std::string cell(const json& line, const Column& column, int digits) {
  const auto value = number_at(line, column.pointer.c_str());
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
  // The least error first; what has none, last, as it came.
  std::vector<size_t> order(group.rows.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto error = [&](size_t i) {
    return number_at(lines[group.rows[i]], columns[0].pointer.c_str()).value_or(std::numeric_limits<double>::infinity());
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return error(a) < error(b); });
  for (const size_t i : order) {
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

std::string text_table(std::span<const json> results, const std::string& against) {
  if (results.empty()) return "no results\n";
  const std::string truth = truth_of(results, against);
  const std::vector<Column> columns = columns_of(results, truth);

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
