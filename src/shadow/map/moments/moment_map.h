// A filterable map made from the depth map: encoded and blurred in one compute pass, then mipmapped.
#pragma once

#include "shadow/map/filter.h"

namespace gnomon {

struct MomentMapInfo {
  std::string filter;  // id: the kernel is convert/<filter>.comp
  VkFormat format = VK_FORMAT_R32_SFLOAT;
  uint32_t depth_samples = 1;
  bool mips = false;
  bool logarithms = false;  // the image holds logarithms: mips average exponentials
};

class MomentMap {
 public:
  static constexpr uint32_t k_max_radius = 10;  // texels
  static constexpr uint32_t k_max_taps = 2 * k_max_radius + 2;

  MomentMap() = default;
  MomentMap(Device& device, const MapInfo& map, const MomentMapInfo& info);

  // radius 0: the encoded texels themselves. Gaussian weights are the middle 2 radius + 1 entries of row 6 radius of Pascal's
  // triangle, normalised (radius 2: row 12). prefilter: a texel holds the mean of itself and its neighbours ahead (2 x 2),
  // before the blur; the reader then looks half a texel back.
  void record(Recorder& recorder, const DrawnMap& drawn, uint32_t radius, bool prefilter);
  const Image& image() const { return image_; }

 private:
  // How a kernel of so many taps is cut into threads.
  struct Shape {
    uint32_t taps, before, columns, rows, share, threads;
    uint32_t columns_of_group() const { return threads * columns - (share ? taps + 1 : 0); }
    bool operator==(const Shape&) const = default;
  };
  Shape shape(uint32_t radius, bool prefilter) const;
  void record_history(Recorder& recorder, const DrawnMap& drawn);

  Device* device_ = nullptr;
  std::string name_;
  MomentMapInfo info_;
  float history_ = 0.0f;
  Image image_, last_;  // change places each frame; last_ only with history_
  Shape shape_ = {};
  Pipeline convert_, mip_, blend_;
};

}  // namespace gnomon
