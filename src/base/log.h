// Log lines and progress, all on stderr: stdout is for data.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace gnomon {

enum class LogLevel { debug, info, warning, error };

// Control characters in the text are shown as text (base/visible_text.h).
void log_line(LogLevel level, std::string_view text);
// `kind`: what a WarningLimit counts by.
void log_warning_of_kind(std::string_view kind, std::string_view text);
void set_log_level(LogLevel lowest_shown);

template <class... Args>
void log_debug(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::debug, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_info(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::info, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_warning(fmt::format_string<Args...> format, Args&&... args) {
  const fmt::string_view kind = format;
  log_warning_of_kind({kind.data(), kind.size()}, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_error(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::error, fmt::format(format, std::forward<Args>(args)...));
}

// What the Progress objects of one thread say, for another thread to show. Must outlive that thread.
class ProgressWatch {
 public:
  void watch_this_thread();

  struct State {
    std::string title;   // empty: nothing that is counted is being done
    double share = 0.0;  // of it, [0, 1]
  };
  State state() const;  // from any thread

 private:
  friend class Progress;
  void report(const std::string& title, double share);

  mutable std::mutex mutex_;
  State state_;
};

// A progress bar, drawn on a terminal only, and only once the work has taken longer than a second. A ProgressWatch of its
// thread sees it from the start.
class Progress {
 public:
  // title: what is being done; total: the number of steps (any unit).
  Progress(std::string title, uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Says that `done` of the total steps are behind us. Cheap: redraws at most ten times a second. Not thread-safe.
  void update(uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  uint64_t total_;
  Clock::time_point start_, last_drawn_;
  bool on_terminal_, drawn_ = false;
  ProgressWatch* watch_;
};

}  // namespace gnomon
