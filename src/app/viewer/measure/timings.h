// What the last frames cost, pass by pass.
#pragma once

#include <algorithm>
#include <deque>

#include "base/statistics.h"
#include "gpu/recorder.h"

namespace gnomon::viewer {

class Timings {
 public:
  static constexpr size_t k_frames = 300;

  // `software`: GPU timestamps lie there, and only the wall clock counts - of the frame, and of passes that are submitted
  // alone.
  explicit Timings(bool software) : software_(software) {}

  void add(const FrameResult& frame);
  // Other passes, or another way to time them. While it is paused the old frames stay until it goes on.
  void clear() { paused ? void(stale_ = true) : frames_.clear(); }
  // The same passes of another picture (settings, size): older frames are shown, but count no longer.
  void change() { counted_ = paused ? counted_ : 0; }
  bool paused = false;  // what is added is dropped

  const std::deque<FrameResult>& frames() const { return frames_; }
  bool of_software() const { return software_; }
  // Passes apart, or of whole frames only?
  bool of_passes() const { return !frames_.empty() && (!software_ || alone()); }
  double pass_ms(const FrameResult& frame, size_t pass) const {
    return alone() ? frame.passes[pass].wall_ms : frame.passes[pass].gpu_ms;
  }
  double stage_ms(const FrameResult& frame, PassStage stage) const;
  double sum_ms(const FrameResult& frame) const;
  // Of the whole frame, on the clock of the passes.
  double frame_ms(const FrameResult& frame) const { return software_ ? frame.wall_ms : frame.gpu_ms; }
  const char* clock() const;

  // How many of the frames, the newest ones, are of the picture as it is.
  size_t counted() const { return std::clamp<size_t>(counted_, 1, frames_.size()); }

  // Over the frames that count; there is one at least.
  template <class Value>
  Summary summary(Value value) const {
    std::vector<double> samples;
    for (size_t i = frames_.size() - counted(); i < frames_.size(); ++i) samples.push_back(value(frames_[i]));
    return summarise(samples);
  }

 private:
  bool alone() const { return frames_.back().submission_ms > 0.0; }

  bool software_, stale_ = false;
  size_t counted_ = 0;
  std::deque<FrameResult> frames_;
};

}  // namespace gnomon::viewer
