#include "app/viewer/window/pace.h"

#include <algorithm>

#include "app/viewer/window/render_scale.h"

namespace gnomon::viewer {

Pace::Draws Pace::next(const Asked& asked, Clock::time_point now) {
  if (asked.changed) changed_at_ = now;
  if (asked.outdated) current_ = false;
  const bool rests = now - changed_at_ >= k_rest;
  last_ = Draws::full;
  if (slow_ && asked.may_shrink && !rests) last_ = Draws::small_maps;
  if (asked.may_stay && rests && current_) last_ = Draws::nothing;
  current_ = asked.may_stay && rests;
  return last_;
}

void Pace::done(float ms, float target_ms) {
  last_ = Draws::nothing;
  if (ms < target_ms) slow_ = false;
}

void Pace::add_frame(float ms, float target_ms, bool exhausted) {
  if (target_ms != target_ms_) forget();
  target_ms_ = target_ms;
  if (last_ == Draws::nothing || refused_) return;
  if (last_ == Draws::full && slow_) return;  // somebody looks at it
  over_ = exhausted && ms > RenderScale::k_tolerance * target_ms ? over_ + 1 : 0;
  if (over_ < k_frames) return;
  over_ = 0;
  if (slow_) divisor_ = std::min(2 * divisor_, k_last_divisor);
  slow_ = true;
}

}  // namespace gnomon::viewer
