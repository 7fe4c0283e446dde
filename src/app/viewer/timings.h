// What the last frames cost.
#pragma once

#include <deque>

#include "gpu/recorder.h"

namespace gnomon::viewer {

class Timings {
 public:
  void add(const FrameResult& frame);
  void clear() { frames_.clear(); }  // passes of another technique have other names
  // A table of the passes, and the frame; `software`: GPU timestamps lie there, and only the wall clock counts.
  void show(bool software) const;

 private:
  std::deque<FrameResult> frames_;
};

}  // namespace gnomon::viewer
