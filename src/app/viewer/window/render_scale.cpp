#include "app/viewer/window/render_scale.h"

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {

int RenderScale::step_of(float scale) {
  return static_cast<int>(
      std::lround(static_cast<float>(k_steps_per_octave) * std::log2(std::clamp(scale, k_least_moving, k_most))));
}

float RenderScale::scale_of(int step) { return std::exp2(static_cast<float>(step) / static_cast<float>(k_steps_per_octave)); }

void RenderScale::forget() {
  slow_ = fast_ = 0, fast_ms_ = last_scale_ = 0.0f;
  fixed_ms_ = -1.0f;
  skip_ = k_settling;
  wait_ = k_first_wait;
  kept_ = 0;
}

float RenderScale::budget_ms() const { return std::max(target_ms_, fixed_ms_ * 4.0f / 3.0f); }

void RenderScale::go_to(int step, float ms) {
  last_scale_ = scale(), last_ms_ = ms;
  went_up_ = step > step_;
  step_ = step;
  slow_ = fast_ = 0, fast_ms_ = 0.0f;
  skip_ = k_settling;
  kept_ = 0;
}

void RenderScale::add_frame(float ms) {
  ++kept_;
  if (skip_ > 0) {
    --skip_;
    return;
  }
  if (last_scale_ > 0.0f) {
    // ms = fixed + per_pixel * scale^2 through two points; noise must not make either negative.
    const float areas = last_scale_ * last_scale_ - scale() * scale();
    fixed_ms_ = std::clamp(ms - std::max((last_ms_ - ms) / areas, 0.0f) * scale() * scale(), 0.0f, ms);
    last_scale_ = 0.0f;
  }
  const int most = step_of(k_most);
  if (ms > budget_ms()) {
    fast_ = 0, fast_ms_ = 0.0f;
    // One slow frame may be somebody else's doing, unless it is far too slow.
    if (++slow_ < 2 && ms < 2.0f * budget_ms()) return;
    if (step_ == least_) return;
    if (went_up_) wait_ = std::min(2 * wait_, k_longest_wait);
    const float octaves = 0.5f * std::log2(ms / budget_ms());  // of pixels, along a side
    go_to(std::max(step_ - std::max(1, static_cast<int>(std::lround(octaves * k_steps_per_octave))), least_), ms);
    return;
  }
  slow_ = 0;
  fast_ms_ = std::max(fast_ms_, ms);
  if (step_ == most || ++fast_ < wait_) return;
  // A step up has 2^(2/4) times the pixels. Where the fixed part is not known, trying tells it.
  const float pixels_ms = fast_ms_ - std::clamp(fixed_ms_, 0.0f, fast_ms_);
  const float next_ms = fast_ms_ + pixels_ms * (std::exp2(2.0f / k_steps_per_octave) - 1.0f);
  if (next_ms < budget_ms() || fixed_ms_ < 0.0f) return go_to(step_ + 1, fast_ms_);
  fast_ = 0, fast_ms_ = 0.0f;
}

}  // namespace gnomon::viewer
