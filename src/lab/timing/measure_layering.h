// Which layering path a device draws cascades fastest with: measured once, then kept (frame/casters/layering_choice.h).
#pragma once

#include <vector>

#include "frame/casters/caster_draws.h"

namespace gnomon {

struct LayeringTime {
  LayeringPath path;
  double ms = 0.0;      // of culling and depth passes of four cascades; 0 where the device lacks the path
  std::string missing;  // the feature that it lacks
};

// Times all paths on the built-in courtyard, stores the fastest, and returns all.
std::vector<LayeringTime> measure_layering(Device& device);

// Measures unless this device was measured before. A second or two, once for each device and driver.
void ensure_layering_measured(Device& device);

}  // namespace gnomon
