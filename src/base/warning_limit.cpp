#include "base/warning_limit.h"

#include <mutex>
#include <vector>

#include "base/log.h"
#include "base/visible_text.h"

namespace gnomon {

struct WarningLimits {
  std::mutex mutex;
  std::vector<WarningLimit*> list;

  static WarningLimits& all() {
    static WarningLimits instance;
    return instance;
  }

  bool any() {
    const std::lock_guard lock(mutex);
    return !list.empty();
  }

  bool admit(std::string_view kind, std::string_view text) {
    const std::lock_guard lock(mutex);
    if (list.empty()) return true;
    if (kind == "{}") kind = text;  // a message made elsewhere: only the same one again is of its kind
    WarningLimit::Kind& entry = list.front()->kinds_[std::string(kind)];
    if (++entry.count > WarningLimit::k_shown) return false;
    entry.last_shown = text;
    return true;
  }
};

WarningLimit::WarningLimit() {
  const std::lock_guard lock(WarningLimits::all().mutex);
  WarningLimits::all().list.push_back(this);
}

WarningLimit::~WarningLimit() {
  {
    const std::lock_guard lock(WarningLimits::all().mutex);
    std::erase(WarningLimits::all().list, this);
  }
  try {
    for (const auto& [kind, entry] : kinds_) {
      if (entry.count <= k_shown) continue;
      log_line(LogLevel::warning, fmt::format("and {} more like this one: {}", entry.count - k_shown, entry.last_shown));
    }
  } catch (...) {  // memory: what is lost is a number
  }
}

void log_warning_of_kind(std::string_view kind, std::string_view text) {
  const std::string line = WarningLimits::all().any() ? visible_line(text) : std::string(text);
  if (WarningLimits::all().admit(kind, line)) log_line(LogLevel::warning, line);
}

}  // namespace gnomon
