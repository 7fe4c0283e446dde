#include "app/viewer/measure/timings.h"

#include <algorithm>
#include <utility>

namespace gnomon::viewer {

void Timings::add(const FrameResult& frame) {
  if (paused) return;
  const auto same = [](const PassResult& a, const PassResult& b) { return a.name == b.name; };
  const auto& passes = frame.passes;
  if (std::exchange(stale_, false) || (!frames_.empty() && !std::ranges::equal(passes, frames_.back().passes, same))) clear();
  if (frames_.empty()) counted_ = 0;
  frames_.push_back(frame);
  ++counted_;
  if (frames_.size() > k_frames) frames_.pop_front();
}

double Timings::stage_ms(const FrameResult& frame, PassStage stage) const {
  double sum = 0.0;
  for (size_t i = 0; i < frame.passes.size(); ++i) sum += frame.passes[i].stage == stage ? pass_ms(frame, i) : 0.0;
  return sum;
}

double Timings::sum_ms(const FrameResult& frame) const {
  double sum = 0.0;
  for (size_t i = 0; i < frame.passes.size(); ++i) sum += pass_ms(frame, i);
  return sum;
}

const char* Timings::clock() const {
  if (!software_) return "GPU time";
  return of_passes() ? "wall clock, each pass alone" : "wall clock of whole frames; separate the passes to time each";
}

}  // namespace gnomon::viewer
