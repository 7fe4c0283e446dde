// Which layering path is fastest on a device: measured once, kept in the user's cache folder.
#pragma once

#include <optional>

#include "frame/casters/caster_draws.h"

namespace gnomon {

// What was measured on this device and driver before, if anything.
std::optional<LayeringPath> measured_layering_path(const DeviceInfo& device);
void store_layering_path(const DeviceInfo& device, LayeringPath path);

// The measured one; without a measurement a pass for each layer, which every device has.
LayeringPath fastest_layering_path(const DeviceInfo& device);

}  // namespace gnomon
