// Blends the depth map of filters that read depth itself with the last frame's.
#pragma once

#include "shadow/map/filter.h"

namespace gnomon {

class DepthHistory {
 public:
  DepthHistory() = default;
  DepthHistory(Device& device, const MapInfo& map);

  // Replaces the depths that were drawn by blended ones.
  void record(Recorder& recorder, const DrawnMap& map);

 private:
  std::string name_;
  float history_ = 0.0f;
  Buffer last_, blended_;  // change places each frame
  Pipeline pipeline_;
};

}  // namespace gnomon
