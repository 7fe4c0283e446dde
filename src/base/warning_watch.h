// The warnings of a while, for who shows them elsewhere than on stderr.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

class WarningWatch {
 public:
  WarningWatch();
  ~WarningWatch();
  WarningWatch(const WarningWatch&) = delete;
  WarningWatch& operator=(const WarningWatch&) = delete;

  // What log_warning was told since this was made, by any thread.
  std::vector<std::string> texts() const;

 private:
  friend struct WarningWatches;
  std::vector<std::string> texts_;
};

}  // namespace gnomon
