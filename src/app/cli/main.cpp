// gnomon: the command line. stdout for data, stderr for people.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "app/cli/command.h"
#include "app/cli/usage_error.h"
#include "base/error.h"
#include "base/log.h"
#include "base/version.h"

int main(int argc, char** argv) {
  using namespace gnomon;
  CLI::App app("A laboratory for real-time shadows: what each technique costs on the GPU, and how wrong it is against rays.",
               "gnomon");
  app.set_version_flag("--version", fmt::format("gnomon {} ({}, {})", version(), commit(), build_type()));
  app.require_subcommand(1);
  cli::Globals globals;
  bool verbose = false;
  app.add_option("--device", globals.device.choice, "part of a Vulkan device's name, or its number in 'gnomon list devices'");
  app.add_flag("--validate", globals.device.validate,
               "Vulkan validation and synchronization validation; any message is an error");
  app.add_flag("--verbose", verbose, "more lines on stderr")->each([](const std::string&) { set_log_level(LogLevel::debug); });
  app.fallthrough();
  cli::add_list(app, globals);
  cli::add_describe(app, globals);
  cli::add_render(app, globals);
  cli::add_compare(app, globals);
  cli::add_bench(app, globals);
  cli::add_report(app, globals);
  cli::add_view(app, globals);
  cli::add_doctor(app, globals);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version come this way too, with exit code 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    log_error("{}", cli::usage_message(app, error));
    return static_cast<int>(ExitCode::usage);
  } catch (const Error& error) {
    log_error("{}", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    log_error("the machine's memory is used up");
    return static_cast<int>(ExitCode::failure);
  } catch (const std::exception& error) {
    log_error("{}", error.what());
    return static_cast<int>(ExitCode::failure);
  }
  return 0;
}
