// The one exception type. Its message is fit for the user: it names the file or key, the place, and what would be valid.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace gnomon {

// Exit codes of the program (stable: scripts rely on them).
enum class ExitCode : int { ok = 0, failure = 1, usage = 2, device = 3, threshold = 4, interrupted = 130 };

class Error : public std::runtime_error {
 public:
  // What a file put into the message is shown as text (base/visible_text.h).
  explicit Error(const std::string& message, ExitCode code = ExitCode::failure);
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

// Throws Error with a formatted message and exit code 1.
template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
  throw Error(fmt::format(format, std::forward<Args>(args)...));
}

// The same for misuse of the command line or of a setting: exit code 2.
template <class... Args>
[[noreturn]] void fail_usage(fmt::format_string<Args...> format, Args&&... args) {
  throw Error(fmt::format(format, std::forward<Args>(args)...), ExitCode::usage);
}

// The same for a missing device or feature: exit code 3.
template <class... Args>
[[noreturn]] void fail_device(fmt::format_string<Args...> format, Args&&... args) {
  throw Error(fmt::format(format, std::forward<Args>(args)...), ExitCode::device);
}

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace gnomon

// A bug in gnomon, not in its input: active in every build, because a wrong number is worse than a stop.
#define GNOMON_ASSERT(condition) ((condition) ? (void)0 : ::gnomon::assertion_failed(#condition, __FILE__, __LINE__))
