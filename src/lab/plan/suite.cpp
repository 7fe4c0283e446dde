// Reading and checking suites; blocks of runs.
#include "lab/plan/suite.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <span>

#include "base/error.h"
#include "base/file.h"
#include "lab/plan/fields.h"
#include "lab/plan/quantity.h"

namespace gnomon {

// Made by the build (cmake/gnomon_embed.cmake) from plan/suites/*.json.
std::span<const std::pair<std::string_view, std::string_view>> embedded_suites();

namespace {

using nlohmann::json;

// The keys of a run that a preset does not have.
constexpr const char* k_run_keys[] = {"name", "presets", "kernel", "texels", "counters", "plot"};

std::string read_quantity(const Fields& fields, const char* key) {
  const std::string of = fields.required_text(key);
  if (!is_quantity(of)) fields.fail_value(key, k_valid_quantities);
  return of;
}

PlotPoint read_plot(const json& object, const std::string& where) {
  const Fields fields(object, where, {"title", "series", "x", "x_label", "of", "published"});
  PlotPoint plot;
  plot.title = fields.required_text("title");
  plot.series = fields.required_text("series");
  plot.x_label = fields.required_text("x_label");
  plot.of = read_quantity(fields, "of");
  if (!fields.has("x")) fail_usage("{}: no key 'x'; it is needed", where);
  plot.x = *fields.number("x");
  plot.published = fields.number("published");
  return plot;
}

SuiteRun read_run(const json& object, const Preset& defaults, const std::string& where) {
  if (!object.is_object()) fail_usage("{}: not an object", where);
  json of_run = json::object(), of_preset = object;
  for (const char* key : k_run_keys) {
    if (object.contains(key)) of_run[key] = object[key], of_preset.erase(key);
  }
  const Fields fields(of_run, where, {"name", "presets", "kernel", "texels", "counters", "plot"});
  SuiteRun run;
  run.name = fields.required_text("name");
  run.view = defaults;
  for (const std::string& name : fields.texts("presets")) overlay(run.view, load_preset(name));
  overlay(run.view, read_preset(of_preset, where));
  run.view.name = where;
  run.kernel = fields.text("kernel").value_or("");
  if (!run.kernel.empty() && run.kernel != "copy" && run.kernel != "surface_read")
    fields.fail_value("kernel", "copy, surface_read");
  const double texels = fields.number("texels").value_or(run.kernel == "copy" ? 2048.0 : 0.0);
  if (fields.has("texels") &&
      (run.kernel != "copy" || texels < 16.0 || texels > 16384.0 || texels != static_cast<uint32_t>(texels))) {
    fields.fail_value("texels", "a whole number from 16 to 16384, with the kernel copy");
  }
  run.texels = static_cast<uint32_t>(texels);
  run.counters = fields.flag("counters");
  if (fields.has("plot")) run.plot = read_plot(fields.at("plot"), where + ".plot");
  if (!run.view.scene) fail_usage("{}: no key 'scene'; it is needed here or in 'defaults'", where);
  if (run.kernel.empty() && run.view.techniques.size() != 1)
    fail_usage("{}: has {} techniques; valid: one, or a 'kernel'", where, run.view.techniques.size());
  return run;
}

std::pair<double, double> read_published(const Fields& fields) {
  const json& value = fields.at("published");
  if (value.is_number()) return {value.get<double>(), value.get<double>()};
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number() || value[0] > value[1]) {
    fields.fail_value("published", "a number, or [from, to]");
  }
  return {value[0].get<double>(), value[1].get<double>()};
}

SuiteRow read_row(const json& object, const std::string& where) {
  const Fields fields(
      object, where,
      {"name", "source", "of", "denominator_of", "numerator", "denominator", "run", "masks", "published", "goal"});
  SuiteRow row;
  row.name = fields.required_text("name");
  row.source = fields.text("source").value_or("");
  const int kinds = fields.has("numerator") + fields.has("run") + fields.has("masks");
  if (kinds != 1 || fields.has("numerator") != fields.has("denominator")) {
    fail_usage("{}: valid: 'numerator' and 'denominator', or 'run', or 'masks'", where);
  }
  if (fields.has("masks")) {
    row.kind = SuiteRow::Kind::masks;
    row.runs = fields.texts("masks");
    if (row.runs.size() < 2) fields.fail_value("masks", "two runs or more");
    return row;
  }
  row.of = row.denominator_of = read_quantity(fields, "of");
  if (fields.has("denominator_of")) row.denominator_of = read_quantity(fields, "denominator_of");
  if (fields.has("run")) {
    row.kind = SuiteRow::Kind::figure;
    row.runs = {fields.required_text("run")};
  } else {
    row.runs = {fields.required_text("numerator"), fields.required_text("denominator")};
  }
  if (fields.has("published")) row.published = read_published(fields);
  row.goal = fields.number("goal");
  return row;
}

template <class T>
std::string names_of(const std::vector<T>& list) {
  std::vector<std::string> names;
  for (const T& item : list) names.push_back(item.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

const json& list_of(const Fields& fields, const char* key, bool needed) {
  static const json none = json::array();
  if (!fields.has(key) && !needed) return none;
  if (!fields.has(key)) fail_usage("{}: no key '{}'; it is needed", fields.where(), key);
  if (!fields.at(key).is_array() || (needed && fields.at(key).empty())) fields.fail_value(key, "a list");
  return fields.at(key);
}

}  // namespace

const SuiteRun* Suite::find(std::string_view run) const {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const SuiteRun& item) { return item.name == run; });
  return found == runs.end() ? nullptr : &*found;
}

Suite parse_suite(std::string_view text, const std::string& name) {
  const json object = parse_plan(text, name);
  const Fields fields(object, name, {"description", "source", "defaults", "runs", "rows"});
  Suite suite;
  suite.name = name;
  suite.description = fields.text("description").value_or("");
  suite.source = fields.text("source").value_or("");
  const Preset defaults = fields.has("defaults") ? read_preset(fields.at("defaults"), name + ": defaults") : Preset();
  const json& runs = list_of(fields, "runs", true);
  for (size_t i = 0; i < runs.size(); ++i) {
    SuiteRun run = read_run(runs[i], defaults, fmt::format("{}: runs[{}]", name, i));
    if (suite.find(run.name)) fail_usage("{}: runs[{}]: a second run '{}'", name, i, run.name);
    suite.runs.push_back(std::move(run));
  }
  const json& rows = list_of(fields, "rows", false);
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}: rows[{}]", name, i);
    SuiteRow row = read_row(rows[i], where);
    for (const std::string& run : row.runs) {
      if (!suite.find(run)) fail_usage("{}: no run '{}'; valid: {}", where, run, names_of(suite.runs));
    }
    suite.rows.push_back(std::move(row));
  }
  return suite;
}

const std::vector<Suite>& builtin_suites() {
  static const auto suites = parse_embedded(embedded_suites(), parse_suite);
  return suites;
}

std::optional<Suite> find_suite(const std::string& name_or_path) {
  for (const Suite& suite : builtin_suites()) {
    if (suite.name == name_or_path) return suite;
  }
  if (!name_or_path.ends_with(".json")) return std::nullopt;
  if (!std::filesystem::is_regular_file(name_or_path)) fail_usage("suite '{}': there is no such file", name_or_path);
  return parse_suite(read_text_file(name_or_path), name_or_path);
}

void keep_only(Suite& suite, const std::vector<std::string>& names) {
  if (names.empty()) return;
  const auto named = [&](const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  for (const std::string& name : names) {
    const bool is_row =
        std::any_of(suite.rows.begin(), suite.rows.end(), [&](const SuiteRow& row) { return row.name == name; });
    if (!is_row && !suite.find(name))
      fail_usage("--only '{}': valid rows: {}; valid runs: {}", name, names_of(suite.rows), names_of(suite.runs));
  }
  std::erase_if(suite.rows, [&](const SuiteRow& row) { return !named(row.name); });
  std::erase_if(suite.runs, [&](const SuiteRun& run) {
    const bool in_row = std::any_of(suite.rows.begin(), suite.rows.end(), [&](const SuiteRow& row) {
      return std::find(row.runs.begin(), row.runs.end(), run.name) != row.runs.end();
    });
    return !in_row && !named(run.name);
  });
}

std::vector<std::vector<size_t>> side_by_side(const Suite& suite) {
  std::vector<size_t> block(suite.runs.size());
  std::iota(block.begin(), block.end(), size_t{0});
  const auto index_of = [&](const std::string& run) { return static_cast<size_t>(suite.find(run) - suite.runs.data()); };
  for (const SuiteRow& row : suite.rows) {
    for (const std::string& run : row.runs) {
      const size_t a = block[index_of(row.runs.front())], b = block[index_of(run)];
      std::replace(block.begin(), block.end(), std::max(a, b), std::min(a, b));
    }
  }
  std::vector<std::vector<size_t>> blocks;
  for (size_t first = 0; first < block.size(); ++first) {
    std::vector<size_t> members;
    for (size_t i = 0; i < block.size(); ++i) {
      if (block[i] == first) members.push_back(i);
    }
    if (!members.empty()) blocks.push_back(std::move(members));
  }
  return blocks;
}

}  // namespace gnomon
