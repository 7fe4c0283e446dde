// gnomon report: HTML (and CSV) again from results.
#include "report/report.h"

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "base/log.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string output, csv;
};

}  // namespace

void add_report(CLI::App& app, const Globals&) {
  auto* command = app.add_subcommand("report", "the HTML report again, from the results of one or more folders");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("folders", arguments->folders, "folders that hold results.jsonl")->required();
  command->add_option("-o,--output", arguments->output, "page to write (default: report.html in the first folder)");
  command->add_option("--csv", arguments->csv, "also write the results as CSV");
  command->callback([arguments] {
    const std::vector<std::filesystem::path> folders(arguments->folders.begin(), arguments->folders.end());
    const std::filesystem::path page = arguments->output.empty() ? folders.front() / "report.html" : std::filesystem::path(arguments->output);
    write_report(folders, page);
    log_info("report: {}", std::filesystem::absolute(page).string());
    if (!arguments->csv.empty()) write_csv(folders, arguments->csv);
  });
}

}  // namespace gnomon::cli
