// What the parser of the command line says, in one line and in gnomon's words.
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace gnomon::cli {

// Names the argument, what is wrong with it, and what would be valid.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gnomon::cli
