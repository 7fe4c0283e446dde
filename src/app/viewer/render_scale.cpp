#include "app/viewer/render_scale.h"

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {

int RenderScale::step_of(float scale) {
  return static_cast<int>(std::lround(static_cast<float>(k_steps_per_octave) * std::log2(std::clamp(scale, k_least, k_most))));
}

float RenderScale::scale() const { return std::exp2(static_cast<float>(step_) / static_cast<float>(k_steps_per_octave)); }

void RenderScale::add_frame(float ms) {
  if (skip_ > 0) {
    --skip_;
    return;
  }
  const int least = step_of(k_least), most = step_of(k_most);
  if (ms > target_ms_) {
    fast_ = 0, fast_ms_ = 0.0f;
    // One slow frame may be somebody else's doing, unless it is far too slow.
    if (++slow_ < 2 && ms < 2.0f * target_ms_) return;
    if (step_ == least) return;
    if (went_up_) wait_ = std::min(2 * wait_, k_longest_wait);
    const float octaves = 0.5f * std::log2(ms / target_ms_);  // of pixels, along a side
    step_ = std::max(step_ - std::max(1, static_cast<int>(std::lround(octaves * k_steps_per_octave))), least);
    went_up_ = false;
    forget();
    return;
  }
  slow_ = 0;
  fast_ms_ = std::max(fast_ms_, ms);
  if (step_ == most || ++fast_ < wait_) return;
  // A step up is at most 2^(2/4) times the pixels.
  if (fast_ms_ * std::exp2(2.0f / k_steps_per_octave) < target_ms_) {
    ++step_;
    went_up_ = true;
    skip_ = k_settling;
  }
  fast_ = 0, fast_ms_ = 0.0f;
}

}  // namespace gnomon::viewer
