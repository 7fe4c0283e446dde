// The time of a path that is played.
#pragma once

namespace gnomon::viewer {

struct Playhead {
  double time_s = 0.0, duration_s = 0.0;
  float speed = 1.0f;  // 1: as the path says
  bool playing = false, loops = true;

  // From the start where it had ended.
  void play();
  // True when there is another picture to show. At the end it stops, or begins again.
  bool advance(double seconds);
};

}  // namespace gnomon::viewer
