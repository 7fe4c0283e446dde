// Thousands of warnings of one kind - a file with 3,000 broken textures - become a few and their number.
#pragma once

#include <map>
#include <string>

namespace gnomon {

// While one lives, of the warnings of one kind - of one format string of log_warning - the first few are shown and the others
// counted, by any thread; its end says how many there were. Of nested ones the outer counts.
class WarningLimit {
 public:
  static constexpr size_t k_shown = 5;

  WarningLimit();
  ~WarningLimit();
  WarningLimit(const WarningLimit&) = delete;
  WarningLimit& operator=(const WarningLimit&) = delete;

 private:
  friend struct WarningLimits;
  struct Kind {
    size_t count = 0;
    std::string last_shown;
  };
  std::map<std::string, Kind, std::less<>> kinds_;
};

}  // namespace gnomon
