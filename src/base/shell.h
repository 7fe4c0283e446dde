// Commands that a person can paste into a shell.
#pragma once

#include <string>

namespace gnomon {

// Quoted for a POSIX shell where it needs to be.
std::string shell_quoted(const std::string& word);

}  // namespace gnomon
