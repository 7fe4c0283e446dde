// How often the surface pass writes each pixel: the same draws in the same order once more, counted by blending.
#pragma once

#include "frame/frame.h"

namespace gnomon {

class Overdraw {
 public:
  Overdraw(Device& device, uvec2 size);

  // Behind Frame::record_surface, whose draws it repeats with one sample a pixel.
  void record(Recorder& recorder, const Frame& frame);
  // R16_SFLOAT, exact up to 2048.
  const Image& image() const { return count_; }
  uvec2 size() const { return {count_.info().width, count_.info().height}; }

 private:
  Image count_, depth_;
  Pipeline pipeline_;
};

}  // namespace gnomon
