// gnomon compare: the main job.
#include "lab/compare.h"

#include <CLI/CLI.hpp>
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
};

// Exit code 4 when a technique's mae is above the threshold: a gate for continuous integration.
void check_threshold(const std::vector<nlohmann::json>& lines, double max_error) {
  std::vector<std::string> exceeding;
  bool measured = false;
  for (const auto& line : lines) {
    if (line["status"] != "ok") continue;
    measured = true;
    const double mae = line["visibility"]["hard"]["mae"];
    if (mae > max_error) exceeding.push_back(fmt::format("{} (mae {:.5f})", line["technique"].get<std::string>(), mae));
  }
  if (!measured) fail_device("--max-error: no technique could be measured");
  if (!exceeding.empty()) {
    throw Error(fmt::format("above --max-error {}: {}", max_error, fmt::join(exceeding, ", ")), ExitCode::threshold);
  }
}

// Passes measured one by one must add up to the frame measured whole (docs/measuring.md); where they do not, times are suspect.
void report_agreement(const std::vector<nlohmann::json>& lines) {
  double worst = 0.0;
  for (const auto& line : lines) {
    if (line["status"] != "ok") continue;
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
  command->add_option("--techniques", arguments->techniques, "names separated by commas, or all")->delimiter(',')->capture_default_str();
  command->add_option("-o,--output", arguments->output, "folder for results.jsonl, images and report.html")->required();
  command->add_option("--max-error", arguments->max_error, "exit with 4 when the mae (hard) of a technique is above this")->check(CLI::Range(0.0, 1.0));
  command->callback([arguments, &globals] {
    CompareOptions options;
    options.view = arguments->view.view();
    options.techniques = arguments->techniques;
    options.output = arguments->output;
    const Settings settings = arguments->view.settings();
    settings.check_used(techniques_named(options.techniques));  // before a device is opened
    const auto device = globals.open_device();
    const auto lines = compare(*device, options, settings);
    std::cout << text_table(lines);
    report_agreement(lines);
    const std::filesystem::path folders[] = {options.output};
    write_report(folders, options.output / "report.html");
    log_info("report: {}", std::filesystem::absolute(options.output / "report.html").string());
    if (arguments->max_error >= 0.0) check_threshold(lines, arguments->max_error);
  });
}

}  // namespace gnomon::cli
