// A filterable map made from the depth map: encoded and blurred in one compute pass, then mipmapped.
#pragma once

#include "shadow/map/filter.h"

namespace gnomon {

struct MomentMapInfo {
  std::string filter;            // id: the kernel is convert/<filter>.comp
  VkFormat format = VK_FORMAT_R32_SFLOAT;
  uint32_t channels = 1;         // of the kernel's MOMENTS type
  uint32_t depth_samples = 1;
  bool mips = false;
  bool logarithms = false;       // the image holds logarithms: mips average exponentials
};

class MomentMap {
 public:
  static constexpr uint32_t k_max_radius = 10;  // texels

  MomentMap() = default;
  MomentMap(Device& device, const MapInfo& map, const MomentMapInfo& info);

  // radius 0: the encoded texels themselves. Gaussian weights are the middle 2 radius + 1 entries of row 6 radius of Pascal's
  // triangle, normalised (radius 2: row 12).
  void record(Recorder& recorder, const DrawnMap& drawn, uint32_t radius);
  const Image& image() const { return image_; }

 private:
  Pipeline make_convert(uint32_t radius) const;
  // Neighbours' depths come from shared memory where a texel read is dear (a CPU's), else from the texture cache: measured on an H200,
  // 0.08 ms against 0.12 for 2048 x 2048 texels.
  bool uses_depth_tile() const { return info_.depth_samples == 1 && device_->info().software; }

  Device* device_ = nullptr;
  std::string name_;
  MomentMapInfo info_;
  Image image_;
  uint32_t radius_ = ~0u, tile_ = 32;
  Pipeline convert_, mip_;
};

}  // namespace gnomon
