// Frames as columns, the newest at the right: the time of each pass upon that of the one before it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/viewer/measure/timings.h"

namespace gnomon::viewer {

class FramePlot {
 public:
  // ImGui's packed colour of a pass, the same as long as the program runs.
  uint32_t colour(const std::string& pass);
  // Fills the width of the window at hand. Returns the frame below the pointer.
  std::optional<size_t> show(const Timings& timings, float height);

 private:
  void column(const Timings& timings, const FrameResult& frame, float left, float right, float bottom, float px_per_ms);

  std::map<std::string, uint32_t> colours_;
};

}  // namespace gnomon::viewer
