#include "app/viewer/camera/path_player.h"

#include <cmath>

namespace gnomon::viewer {

void Playhead::play() {
  if (time_s >= duration_s) time_s = 0.0;
  playing = duration_s > 0.0;
}

bool Playhead::advance(double seconds) {
  if (!playing) return false;
  time_s += seconds * static_cast<double>(speed);
  if (time_s >= duration_s) {
    time_s = loops ? std::fmod(time_s, duration_s) : duration_s;
    playing = loops;
  }
  return true;
}

}  // namespace gnomon::viewer
