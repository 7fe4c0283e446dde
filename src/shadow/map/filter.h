// A filter decides what a texel stores and how it is read back: passes that turn the depth map into what it reads, and in GLSL
// lit() (shadow/map/glsl/visibility.glsl).
#pragma once

#include "base/params.h"
#include "frame/frame.h"

namespace gnomon {

class Filter {
 public:
  virtual ~Filter() = default;
  virtual void set(const ParamBlock& params) = 0;

  // Called once per build: makes what the filter needs beside the depth map.
  virtual void prepare(Device& /*device*/, const Image& /*depth_map*/) {}
  // Passes between the depth map and the resolve. None where the filter reads depth itself.
  virtual void record(Recorder& /*recorder*/, const Image& /*depth_map*/) {}
  // What lit() reads.
  virtual const Image& map(const Image& depth_map) const { return depth_map; }
};

}  // namespace gnomon
