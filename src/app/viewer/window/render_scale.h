// The picture's size relative to the window's: chosen so that a frame takes at most a given time.
#pragma once

#include <algorithm>

namespace gnomon::viewer {

// A frame costs something per pixel, and something that no size changes (maps, interface). The size follows the measured times
// in steps: down at once, up with hesitation, so that it comes to rest. Where the fixed part alone is near the target or over
// it, pixels may take a third of what it takes: less would cost the picture and gain nothing.
class RenderScale {
 public:
  static constexpr float k_least = 0.25f, k_most = 1.0f;
  static constexpr float k_least_moving = 0.125f;  // of a picture that is soon replaced

  // `start`: [k_least_moving, k_most].
  RenderScale(float target_ms, float start) : target_ms_(target_ms), step_(step_of(start)) {}

  float scale() const { return scale_of(step_); }
  void set_target(float ms) { target_ms_ = ms; }
  void set_least(float scale) { step_ = std::max(step_, least_ = step_of(scale)); }
  // Whether another size would not help: it is the least, or what no size changes takes too long by itself.
  bool exhausted() const { return skip_ == 0 && (step_ == least_ || budget_ms() > k_tolerance * target_ms_); }
  // Whether it has kept its size for a while.
  bool settled() const { return kept_ >= k_settled; }
  static constexpr float k_tolerance = 1.25f;  // of the target: sizes come in steps
  // Of a whole frame at this scale, from input to picture.
  void add_frame(float ms);
  // What was measured belongs to other settings.
  void forget();

 private:
  static constexpr int k_steps_per_octave = 4;
  static constexpr int k_settling = 2;  // frames after a change that say nothing: pipelines warm up, images are new
  static constexpr int k_settled = 10;
  static constexpr int k_first_wait = 6, k_longest_wait = 96;
  static int step_of(float scale);
  static float scale_of(int step);
  void go_to(int step, float ms);
  float budget_ms() const;

  float target_ms_;
  int least_ = step_of(k_least);
  int step_;  // scale is 2^(step / k_steps_per_octave)
  // Of a frame, whatever its size: from the last two sizes. Below 0: not known yet.
  float fixed_ms_ = -1.0f;
  // The last size that was left, and its time; 0: none.
  float last_scale_ = 0.0f, last_ms_ = 0.0f;
  float fast_ms_ = 0.0f;  // longest of the fast frames in a row
  int slow_ = 0, fast_ = 0, skip_ = k_settling;
  int wait_ = k_first_wait;  // fast frames in a row before the next step up: more each time that one had to be taken back
  bool went_up_ = false;
  int kept_ = 0;  // frames of this size
};

}  // namespace gnomon::viewer
