// gnomon compare: the main job.
#include "lab/experiment/compare.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "base/error.h"
#include "base/log.h"
#include "report/report.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  ViewArguments view;
  std::vector<std::string> techniques = {"all"};
  std::string output;
  double max_error = -1.0;
  std::string against = k_truth_names[0];
  bool resume = false;
};

bool is_measured(const nlohmann::json& line) { return line["status"] == "ok"; }

// A gate for continuous integration: exit code 4 when a technique's mae is above the threshold, 3 when there is nothing to hold
// against it. A technique that the user named must be measured under every light; of "all", those that cannot run here do not
// count.
void check_threshold(const std::vector<nlohmann::json>& lines, const Arguments& arguments) {
  std::vector<std::string> exceeding, missing;
  bool measured = false;
  for (const auto& line : lines) {
    const auto name = line["technique"].get<std::string>();
    if (line["status"] != "ok") {
      const bool named =
          std::find(arguments.techniques.begin(), arguments.techniques.end(), name) != arguments.techniques.end();
      if (named) missing.push_back(fmt::format("{} ({})", name, line["reason"].get<std::string>()));
      continue;
    }
    const auto& scores = line["visibility"];
    if (!scores.contains(arguments.against)) {
      missing.push_back(fmt::format("{} (there is no truth '{}' here: the light has no size, or the settings leave it out)",
                                    name, arguments.against));
      continue;
    }
    const auto& mae = scores[arguments.against]["mae"];
    measured = true;
    if (!mae.is_number() || !(mae.get<double>() <= arguments.max_error))
      exceeding.push_back(fmt::format("{} (mae {})", name, mae.dump()));
  }
  if (!exceeding.empty()) {
    const std::string also = missing.empty() ? "" : fmt::format("; not measured: {}", fmt::join(missing, ", "));
    throw Error(fmt::format("above --max-error {}: {}{}", arguments.max_error, fmt::join(exceeding, ", "), also),
                ExitCode::threshold);
  }
  if (!missing.empty()) fail_device("--max-error: not measured: {}", fmt::join(missing, ", "));
  if (!measured) fail_device("--max-error: no technique could be measured");
}

void warn_of_repeats(const std::vector<std::string>& names) {
  std::vector<std::string> repeated;
  for (auto name = names.begin(); name != names.end(); ++name) {
    const bool again = std::find(names.begin(), name, *name) != name;
    if (again && std::find(repeated.begin(), repeated.end(), *name) == repeated.end()) repeated.push_back(*name);
  }
  if (!repeated.empty()) log_warning("--techniques names {} more than once: measured once", fmt::join(repeated, ", "));
}

// Passes measured one by one must add up to the frame measured whole (docs/measuring.md); where they do not, times are suspect.
void report_agreement(const std::vector<nlohmann::json>& lines) {
  double worst = 0.0;
  if (std::none_of(lines.begin(), lines.end(), is_measured)) return;
  for (const auto& line : lines) {
    if (!is_measured(line)) continue;
    const double frame = line["timing"]["frame_ms"], sum = line["timing"]["sum_of_passes_ms"];
    if (frame > 0.0) worst = std::max(worst, std::abs(sum / frame - 1.0));
  }
  const std::string text = fmt::format("sum of passes against whole frames: at most {:.1f} % apart", 100.0 * worst);
  worst > 0.1 ? log_warning("{}; the machine may be busy: times are not to be trusted", text) : log_info("{}", text);
}

}  // namespace

void add_compare(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand("compare", "techniques side by side: cost, error against rays, pictures, report");
  const auto arguments = std::make_shared<Arguments>();
  arguments->view.add_to(*command);
  command->add_option("--techniques", arguments->techniques, "names separated by commas, or all")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("-o,--output", arguments->output,
                   "folder for results.jsonl, images and report.html; a finished run replaces the former one")
      ->required();
  command
      ->add_option("--max-error", arguments->max_error,
                   "exit with 4 when the mae (by --against) of a technique is above this, with 3 when a named technique cannot "
                   "be measured")
      ->check(CLI::Range(0.0, 1.0));
  add_against(*command, arguments->against);
  command->add_flag("--resume", arguments->resume,
                    "continue an unfinished run in the output folder: results that are still true are kept");
  command->callback([arguments, command, &globals] {
    CompareOptions options;
    options.view = arguments->view.view();
    options.techniques = arguments->techniques;
    const Preset preset = arguments->view.preset();
    if (command->get_option("--techniques")->count() == 0 && !preset.techniques.empty()) {
      options.techniques = arguments->techniques = preset.techniques;
    }
    options.output = arguments->output;
    options.resume = arguments->resume;
    const Settings settings = arguments->view.settings(options.techniques);
    settings.check_used(techniques_named(options.techniques));  // before a device is opened
    warn_of_repeats(options.techniques);
    arguments->view.write_preset(options.techniques, false);
    const auto device = globals.open_device();
    const auto folder = compare(*device, options, settings);
    const auto& lines = folder->lines();
    std::cout << text_table(lines, arguments->against);
    report_agreement(lines);
    const std::filesystem::path folders[] = {folder->unfinished()};
    write_report(folders, folder->unfinished() / "report.html", arguments->against);
    folder->publish();
    log_info("report: {}", std::filesystem::absolute(options.output / "report.html").string());
    if (arguments->max_error >= 0.0) check_threshold(lines, *arguments);
    if (std::none_of(lines.begin(), lines.end(), is_measured))
      fail_device("no technique could be measured; the table says why");
  });
}

}  // namespace gnomon::cli
