// CLI11's messages, taken apart by their text: what they are about is told in no other way.
#include "app/cli/usage_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <regex>

namespace gnomon::cli {
namespace {

std::string subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// "{error->2,mask->1}" or "{error,mask}" -> "error, mask"
std::string member_names(std::string members) {
  members = std::regex_replace(members, std::regex("->[^,]*"), "");
  return std::regex_replace(members, std::regex(","), ", ");
}

// "0.500000" -> "0.5"
std::string short_number(const std::string& text) {
  return text.find('.') == text.npos ? text : fmt::format("{:g}", std::stod(text));
}

// "UINT in [1 - 8]" -> what a person would call it
std::string kind_name(const CLI::App& app, const CLI::App* command, const std::string& option) {
  const CLI::Option* found = command ? command->get_option_no_throw(option) : nullptr;
  if (!found) found = app.get_option_no_throw(option);
  const std::string type = found ? found->get_type_name() : "";
  if (type.starts_with("UINT")) return "a whole number, 0 or more";
  if (type.starts_with("INT")) return "a whole number";
  if (type.starts_with("FLOAT")) return "a number";
  return "a value of another kind";
}

std::string unexpected(const CLI::App& app, const CLI::App* command, const std::string& argument) {
  if (argument.starts_with("-") && argument != "-") {
    return fmt::format("unknown option '{}'; valid: {}", argument.substr(0, argument.find('=')),
                       option_names(command ? *command : app));
  }
  if (!command) return fmt::format("unknown subcommand '{}'; valid: {}", argument, subcommand_names(app));
  return fmt::format("{}: '{}' is one argument too many; see 'gnomon {} --help'", command->get_name(), argument,
                     command->get_name());
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App* command = chosen.empty() ? nullptr : chosen.front();
  const auto rest = app.remaining(true);
  const std::string what = error.what();
  // Not by its name: that of an unexpected argument is the application's.
  const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
  if (is(CLI::ExitCodes::ExtrasError) && !rest.empty()) return unexpected(app, command, rest.front());
  if (is(CLI::ExitCodes::RequiredError) && !command) {
    return rest.empty() ? fmt::format("a subcommand is missing; valid: {}", subcommand_names(app))
                        : unexpected(app, command, rest.front());
  }
  if (is(CLI::ExitCodes::RequiredError)) {
    // A wrong option is more likely the mistake than the one that it was taken for.
    if (!rest.empty() && rest.front().starts_with("-")) return unexpected(app, command, rest.front());
    return fmt::format("{}: {}; see 'gnomon {} --help'", command->get_name(), what, command->get_name());
  }
  std::smatch part;
  if (std::regex_match(what, part, std::regex(R"((\S+): Check (.*) value in \{([^}]*)\}.* FAILED)")) ||
      std::regex_match(what, part, std::regex(R"((\S+): (.*) not in \{([^}]*)\})"))) {
    return fmt::format("{} {}: valid: {}", part.str(1), part.str(2), member_names(part.str(3)));
  }
  if (std::regex_match(what, part, std::regex(R"((\S+): Value (.*) not in range (\S+) to (\S+))"))) {
    return fmt::format("{} {}: valid: {} to {}", part.str(1), part.str(2), short_number(part.str(3)),
                       short_number(part.str(4)));
  }
  if (std::regex_match(what, part, std::regex(R"(Could not convert: (\S+) = (.*))"))) {
    return fmt::format("{} {}: valid: {}", part.str(1), part.str(2), kind_name(app, command, part.str(1)));
  }
  if (std::regex_match(what, part, std::regex(R"((\S+): \d+ required \S+ missing)")))
    return fmt::format("{}: its value is missing", part.str(1));
  return what;
}

}  // namespace gnomon::cli
