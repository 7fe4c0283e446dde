// What a frame draws, so that input is answered in time where drawing everything takes too long.
#pragma once

#include <chrono>
#include <cstdint>

namespace gnomon::viewer {

// While something changes the picture has the size that is drawn in time (RenderScale). Once it rests it is drawn finer, once,
// and stays. The size does not help where the maps alone take longer than a frame may (a CPU, moments, many lights). Such a
// view is slow: while something changes its maps are smaller ones; once it rests it is drawn in full, and that picture stays.
class Pace {
 public:
  enum class Draws { full, small_maps, nothing };
  using Clock = std::chrono::steady_clock;

  struct Asked {
    bool changed;     // the view is another one than in the last frame
    bool outdated;    // what lies over it is: the picture that stays is drawn again
    bool may_shrink;  // it may do without maps in full size
    bool may_stay;    // it need not be drawn in each frame
  };
  // What the coming frame draws.
  Draws next(const Asked& asked, Clock::time_point now);
  // The picture that was to stay is gone.
  void draw_again() { last_ = Draws::full; }
  // Whether it is the picture that is to stay: as nothing hurries it, input may end it.
  bool draws_once() const { return current_ && last_ == Draws::full; }
  bool stays() const { return current_ && last_ == Draws::nothing; }  // it was drawn to its end
  void done(float ms, float target_ms);                               // it took so long
  void give_up() { last_ = Draws::nothing, current_ = false; }
  // Whether the window shows a picture with maps in full size.
  bool shows_full() const { return current_ || last_ == Draws::full; }
  // How long a frame took that had the device to itself, from input to picture. `exhausted`: another size of the picture would
  // not help.
  void add_frame(float ms, float target_ms, bool exhausted);
  // Smaller maps cannot be had: until the next forget, no view is slow.
  void refuse() { slow_ = false, refused_ = true; }
  // What was measured belongs to other settings.
  void forget() { *this = Pace(); }

  bool slow() const { return slow_; }
  Draws last() const { return last_; }
  // Sides of the smaller maps are those in force divided by this.
  uint32_t divisor() const { return divisor_; }

 private:
  static constexpr std::chrono::milliseconds k_rest{200};
  static constexpr int k_frames = 4;  // that agree: one slow frame may be somebody else's doing
  static constexpr uint32_t k_first_divisor = 4, k_last_divisor = 8;

  bool slow_ = false, refused_ = false;
  bool current_ = false;  // the picture that stays is of what is shown, or is being drawn
  Draws last_ = Draws::full;
  float target_ms_ = 0.0f;
  int over_ = 0;
  uint32_t divisor_ = k_first_divisor;
  Clock::time_point changed_at_;
};

}  // namespace gnomon::viewer
