// gnomon report: HTML (and CSV) again from results.
#include "report/report.h"

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "base/error.h"
#include "base/log.h"
#include "base/result_folder.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string output, csv, against = k_truth_names[0];
};

// A run that did not finish is no part of the report, and must not go unseen.
void look_for_unfinished(const std::filesystem::path& folder) {
  settle_results(folder);
  const auto run = unfinished_run(folder);
  if (!run) return;
  const std::string state =
      fmt::format("an unfinished run lies in {} ({} result{})", run->folder.string(), run->lines, run->lines == 1 ? "" : "s");
  const std::string advice = "its command with --resume finishes it, 'gnomon report' of that folder shows it as it is";
  if (!std::filesystem::exists(folder / "results.jsonl"))
    fail("{}: holds no finished result: {}; {}", folder.string(), state, advice);
  log_warning("{}: the report is of the last finished run; {}; {}", folder.string(), state, advice);
}

}  // namespace

void add_report(CLI::App& app, const Globals&) {
  auto* command = app.add_subcommand("report", "the HTML report again, from the results of one or more folders");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("folders", arguments->folders, "folders that hold results.jsonl")->required();
  command->add_option("-o,--output", arguments->output, "page to write (default: report.html in the first folder)");
  command->add_option("--csv", arguments->csv, "also write the results as CSV");
  add_against(*command, arguments->against);
  command->callback([arguments] {
    const std::vector<std::filesystem::path> folders(arguments->folders.begin(), arguments->folders.end());
    const std::filesystem::path page =
        arguments->output.empty() ? folders.front() / "report.html" : std::filesystem::path(arguments->output);
    for (const auto& folder : folders) look_for_unfinished(folder);
    write_report(folders, page, arguments->against);
    log_info("report: {}", std::filesystem::absolute(page).string());
    if (!arguments->csv.empty()) write_csv(folders, arguments->csv);
  });
}

}  // namespace gnomon::cli
