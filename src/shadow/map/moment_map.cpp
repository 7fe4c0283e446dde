// Conversion, blur, mips.
#include "shadow/map/moment_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gnomon {
namespace {

struct ConvertArguments {
  uint64_t views, params;
  uint32_t depth_image, target, size, unused;
  float weights[MomentMap::k_max_radius + 1];  // from the middle outward
};

void fill_weights(uint32_t radius, float* weights) {
  double sum = 0.0;
  for (uint32_t i = 0; i <= radius; ++i) {
    // C(6r, 3r + i) relative to C(6r, 3r).
    double weight = 1.0;
    for (uint32_t k = 1; k <= i; ++k) weight *= double(3 * radius - k + 1) / double(3 * radius + k);
    weights[i] = static_cast<float>(weight);
    sum += i == 0 ? weight : 2.0 * weight;
  }
  for (uint32_t i = 0; i <= radius; ++i) weights[i] = static_cast<float>(weights[i] / sum);
}

}  // namespace

MomentMap::MomentMap(Device& device, const MapInfo& map, const MomentMapInfo& info) : device_(&device), name_(map.name), info_(info) {
  ImageInfo image;
  image.name = map.name + " moments";
  image.width = image.height = map.size;
  image.layers = map.layers;
  image.array = true;
  image.format = info.format;
  image.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (info.mips) image.mips = static_cast<uint32_t>(std::bit_width(map.size));
  image_ = Image(device, image);
  if (info.mips) mip_ = make_compute_pipeline(device, "shadow/map/mip.comp", {info.logarithms ? 1u : 0u});
}

Pipeline MomentMap::make_convert(uint32_t radius) const {
  return make_compute_pipeline(*device_, "convert/" + info_.filter + ".comp", {info_.depth_samples, radius, tile_, uses_depth_tile() ? 1u : 0u});
}

void MomentMap::record(Recorder& recorder, const DrawnMap& drawn, uint32_t radius) {
  if (radius != radius_) {
    // Depths and encoded values of a tile and its apron, and the tile's columns blurred along rows, lie in shared memory, of which
    // every device has 32 KiB.
    const auto bytes = [&](uint32_t tile) {
      const uint32_t side = tile + 2 * radius, depths = (side + 3) * (side + 3);
      return 4 * ((uses_depth_tile() ? depths : 0) + (radius == 0 ? 0 : info_.channels * side * (side + tile)));
    };
    tile_ = bytes(32) <= 32768 ? 32 : bytes(16) <= 32768 ? 16 : 8;
    convert_ = make_convert(radius);
    radius_ = radius;
  }
  const uint32_t size = image_.info().width;
  ConvertArguments arguments = {drawn.views.address(), drawn.params, drawn.depth.sampled(), image_.storage(), size, 0, {}};
  fill_weights(radius, arguments.weights);
  recorder.pass(name_ + "/convert", PassStage::build,
                {{drawn.depth, Use::compute_read}, {drawn.views, Use::compute_read}, {image_, Use::compute_write}}, [&](Commands& commands) {
                  commands.bind(convert_);
                  commands.push(arguments);
                  const uint32_t tiles = (size + tile_ - 1) / tile_;
                  commands.dispatch(glm::uvec3(tiles, tiles, image_.info().layers));
                });
  if (!info_.mips) return;
  recorder.pass(name_ + "/mips", PassStage::build, {{image_, Use::compute_write}}, [&](Commands& commands) {
    commands.bind(mip_);
    for (uint32_t mip = 1; mip < image_.info().mips; ++mip) {
      struct Arguments {
        uint32_t from, to, size, unused;
      };
      const uint32_t mip_size = std::max(size >> mip, 1u);
      if (mip > 1) commands.compute_barrier();
      commands.push(Arguments{image_.storage(mip - 1), image_.storage(mip), mip_size, 0});
      commands.dispatch(glm::uvec3((mip_size + 7) / 8, (mip_size + 7) / 8, image_.info().layers));
    }
  });
}

}  // namespace gnomon
