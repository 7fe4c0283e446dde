// Suites of benchmarks as data: runs, and what is said about them (ratios, figures, masks that must be equal). One JSON file
// each (src/lab/plan/suites/*.json, or a user's own): docs/measuring.md, "Suites".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/plan/preset.h"

namespace gnomon {

// A point of a plot in the report: time `of` the run at `x`, in one of several series.
struct PlotPoint {
  std::string title, series, x_label, of;
  double x = 0.0;
  std::optional<double> published;  // ms
};

struct SuiteRun {
  std::string name;
  Preset view;            // scene, technique, settings; defaults and presets are already in it
  std::string kernel;     // instead of a technique: "copy" or "surface_read" (lab/timing/bench_kernels.h)
  uint32_t texels = 0;    // side of what "copy" copies
  bool counters = false;  // the table shows its draws and triangles pass by pass
  std::optional<PlotPoint> plot;
};

// What is said about runs. Ratio: numerator over denominator. Figure: numerator alone. Masks: all runs must give the same bits.
struct SuiteRow {
  enum class Kind { ratio, figure, masks };
  Kind kind = Kind::ratio;
  std::string name, source;
  std::string of, denominator_of;                      // quantities (lab/plan/quantity.h)
  std::vector<std::string> runs;                       // ratio: numerator, denominator; figure: one
  std::optional<std::pair<double, double>> published;  // range
  std::optional<double> goal;                          // at most
};

struct Suite {
  std::string name, description, source;
  std::vector<SuiteRun> runs;
  std::vector<SuiteRow> rows;

  const SuiteRun* find(std::string_view run) const;
};

// Ordered by name.
const std::vector<Suite>& builtin_suites();
// Nothing where no built-in suite and no .json file has that name. Throws Error (usage) for a file that is no suite.
std::optional<Suite> find_suite(const std::string& name_or_path);
Suite parse_suite(std::string_view json, const std::string& name);

// Leaves the rows and runs of these names (a row brings its runs along). Throws Error (usage) for a name that neither has.
void keep_only(Suite& suite, const std::vector<std::string>& names);

// Runs that rows connect are measured side by side: indices of runs, in the suite's order.
std::vector<std::vector<size_t>> side_by_side(const Suite& suite);

}  // namespace gnomon
