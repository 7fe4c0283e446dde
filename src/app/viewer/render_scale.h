// The picture's size relative to the window's: chosen so that a frame takes at most a given time.
#pragma once

#include <cstdint>

namespace gnomon::viewer {

// A picture has a cost per pixel and one that no size changes (maps, interface). The size follows the measured times in steps, down at
// once and up with hesitation, so that it comes to rest.
class RenderScale {
 public:
  static constexpr float k_least = 0.125f, k_most = 1.0f;

  // `start`: [k_least, k_most].
  RenderScale(float target_ms, float start) : target_ms_(target_ms), step_(step_of(start)) {}

  float scale() const;
  float target_ms() const { return target_ms_; }
  void set_target(float ms) { target_ms_ = ms; }
  // Of a whole frame at this scale, from input to picture.
  void add_frame(float ms);
  // What was measured belongs to other settings.
  void forget() { slow_ = fast_ = 0, skip_ = k_settling; }

 private:
  static constexpr int k_steps_per_octave = 4;
  static constexpr int k_settling = 2;  // frames after a change that say nothing: pipelines warm up, images are new
  static int step_of(float scale);

  float target_ms_;
  int step_;            // scale is 2^(step / k_steps_per_octave)
  float fast_ms_ = 0.0f;  // longest of the fast frames in a row
  int slow_ = 0, fast_ = 0, skip_ = k_settling;
  int wait_ = k_first_wait;  // fast frames in a row before the next step up: more each time that one had to be taken back
  bool went_up_ = false;
  static constexpr int k_first_wait = 6, k_longest_wait = 96;
};

}  // namespace gnomon::viewer
