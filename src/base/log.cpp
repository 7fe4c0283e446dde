// spdlog behind a small surface, so that its headers are compiled once.
#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "base/interrupt.h"
#include "base/visible_text.h"
#include "base/warning_watch.h"

namespace gnomon {

struct WarningWatches {
  std::mutex mutex;
  std::vector<WarningWatch*> list;

  void add(std::string_view text) {
    const std::lock_guard lock(mutex);
    for (WarningWatch* watch : list) watch->texts_.emplace_back(text);
  }
};

namespace {

WarningWatches& watches() {
  static WarningWatches all;
  return all;
}

spdlog::level::level_enum to_spdlog(LogLevel level) {
  switch (level) {
    case LogLevel::debug:
      return spdlog::level::debug;
    case LogLevel::info:
      return spdlog::level::info;
    case LogLevel::warning:
      return spdlog::level::warn;
    case LogLevel::error:
      return spdlog::level::err;
  }
  return spdlog::level::info;
}

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> instance = [] {
    auto created = spdlog::stderr_color_mt("gnomon");
    created->set_pattern("%^%n: %l:%$ %v");
    return created;
  }();
  return *instance;
}

}  // namespace

void log_line(LogLevel level, std::string_view text) {
  if (level == LogLevel::info) {
    logger().set_pattern("%n: %v");
  } else {
    logger().set_pattern("%n: %^%l%$: %v");
  }
  const std::string visible = visible_text(text);
  logger().log(to_spdlog(level), visible);
  if (level == LogLevel::warning) watches().add(visible);
}

WarningWatch::WarningWatch() {
  const std::lock_guard lock(watches().mutex);
  watches().list.push_back(this);
}

WarningWatch::~WarningWatch() {
  const std::lock_guard lock(watches().mutex);
  std::erase(watches().list, this);
}

std::vector<std::string> WarningWatch::texts() const {
  const std::lock_guard lock(watches().mutex);
  return texts_;
}

void set_log_level(LogLevel lowest_shown) { logger().set_level(to_spdlog(lowest_shown)); }

namespace {

thread_local ProgressWatch* watch_of_thread = nullptr;

}  // namespace

void ProgressWatch::watch_this_thread() { watch_of_thread = this; }

ProgressWatch::State ProgressWatch::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void ProgressWatch::report(const std::string& title, double share) {
  const std::lock_guard lock(mutex_);
  state_ = {title, share};
}

Progress::Progress(std::string title, uint64_t total)
    : title_(visible_text(title)),
      total_(std::max<uint64_t>(total, 1)),
      start_(Clock::now()),
      last_drawn_(start_),
      on_terminal_(isatty(2) == 1),
      watch_(watch_of_thread) {
  if (watch_) watch_->report(title_, 0.0);
}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  if (watch_) watch_->report({}, 0.0);
}

void Progress::update(uint64_t done) {
  using namespace std::chrono_literals;
  check_cancelled();
  if (!on_terminal_ && !watch_) return;
  const auto now = Clock::now();
  if (now - last_drawn_ < 100ms) return;
  last_drawn_ = now;
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  if (watch_) watch_->report(title_, share);
  if (!on_terminal_ || now - start_ < 1s) return;
  drawn_ = true;
  constexpr int k_width = 32;
  const int filled = static_cast<int>(share * k_width);
  const std::string bar =
      std::string(static_cast<size_t>(filled), '#') + std::string(static_cast<size_t>(k_width - filled), '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %3.0f %%", title_.c_str(), bar.c_str(), 100.0 * share);
  std::fflush(stderr);
}

}  // namespace gnomon
