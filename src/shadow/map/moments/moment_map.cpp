// Conversion, blur, mips.
#include "shadow/map/moments/moment_map.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

#include "frame/surface/pixel_tile.glsl"

namespace gnomon {
namespace {

struct ConvertArguments {
  uint64_t views, params;
  uint32_t depth_image, target, size;
  float weights[MomentMap::k_max_taps];
};

// From the first tap to the last.
void fill_weights(uint32_t radius, bool prefilter, float* weights) {
  std::vector<double> gaussian(2 * radius + 1, 1.0);
  for (uint32_t i = 1; i <= radius; ++i) {
    // C(6r, 3r + i) relative to C(6r, 3r).
    gaussian[radius + i] = gaussian[radius - i] =
        gaussian[radius + i - 1] * double(3 * radius - i + 1) / double(3 * radius + i);
  }
  const double sum = std::accumulate(gaussian.begin(), gaussian.end(), 0.0);
  // The mean with the neighbour ahead, then the Gaussian: one kernel.
  for (uint32_t i = 0; i < gaussian.size(); ++i) {
    weights[i] += static_cast<float>(gaussian[i] / sum * (prefilter ? 0.5 : 1.0));
    if (prefilter) weights[i + 1] += static_cast<float>(gaussian[i] / sum * 0.5);
  }
}

// With 16 bits a channel a blend never arrives: a twentieth of what is still missing rounds to nothing.
VkFormat format_for_history(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R16G16_SFLOAT:
      return VK_FORMAT_R32G32_SFLOAT;
    case VK_FORMAT_R16G16B16A16_SFLOAT:
    case VK_FORMAT_R16G16B16A16_UNORM:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    default:
      return format;
  }
}

}  // namespace

MomentMap::MomentMap(Device& device, const MapInfo& map, const MomentMapInfo& info)
    : device_(&device), name_(map.name), info_(info), history_(map.history) {
  ImageInfo image;
  image.name = map.name + " moments";
  image.width = image.height = map.size;
  image.layers = map.layers;
  image.array = true;
  image.format = history_ > 0.0f ? format_for_history(info.format) : info.format;
  image.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (info.mips) image.mips = static_cast<uint32_t>(std::bit_width(map.size));
  image_ = Image(device, image);
  if (history_ > 0.0f) {
    image.name = map.name + " last moments";
    last_ = Image(device, image);
    blend_ = make_compute_pipeline(device, "history/" + info.filter + ".comp", {info.depth_samples, info.logarithms ? 1u : 0u});
  }
  if (info.mips) mip_ = make_compute_pipeline(device, "shadow/map/moments/mip.comp", {info.logarithms ? 1u : 0u});
}

MomentMap::Shape MomentMap::shape(uint32_t radius, bool prefilter) const {
  Shape shape = {
      .taps = 2 * radius + 1 + (prefilter ? 1 : 0), .before = radius, .columns = 1, .rows = 34, .share = 1, .threads = 128};
  if (shape.taps == 1) shape.share = 0;
  // Measured on an H200: 64 to 512 threads, 16 to 64 rows, 1 to 4 columns; with 34 rows the 1037 groups of a map of 2048 x 2048
  // fill its 132 processors evenly. And on a CPU, with registers instead of shared memory; wider kernels would not stay in
  // them.
  if (device_->info().software && shape.taps <= 16) {
    shape.columns = 8;
    shape.rows = 64;
    shape.share = 0;
    shape.threads = 64;
  }
  return shape;
}

void MomentMap::record_history(Recorder& recorder, const DrawnMap& drawn) {
  struct Arguments {
    uint64_t views, last_views, params;
    uint32_t depth_image, map, last_map, size;
    float history;
  };
  const uint32_t size = image_.info().width;
  const Arguments arguments = {drawn.views.address(),
                               drawn.last_views->address(),
                               drawn.params,
                               drawn.depth.sampled(),
                               image_.storage(),
                               last_.sampled(),
                               size,
                               history_};
  recorder.pass(name_ + "/temporal", PassStage::build,
                {{drawn.depth, Use::compute_read},
                 {drawn.views, Use::compute_read},
                 {*drawn.last_views, Use::compute_read},
                 {last_, Use::compute_read},
                 {image_, Use::compute_write}},
                [&](Commands& commands) {
                  commands.bind(blend_);
                  commands.push(arguments);
                  const uint32_t tiles = (size + k_pixel_tile - 1) / k_pixel_tile;
                  commands.dispatch(glm::uvec3(tiles, tiles, image_.info().layers));
                });
}

void MomentMap::record(Recorder& recorder, const DrawnMap& drawn, uint32_t radius, bool prefilter) {
  if (history_ > 0.0f) std::swap(image_, last_);  // the older of the two is written over
  if (const Shape wanted = shape(radius, prefilter); !(wanted == shape_)) {
    shape_ = wanted;
    convert_ = make_compute_pipeline(
        *device_, "convert/" + info_.filter + ".comp",
        {info_.depth_samples, shape_.taps, shape_.before, shape_.columns, shape_.rows, shape_.share, shape_.threads});
  }
  const uint32_t size = image_.info().width;
  ConvertArguments arguments = {drawn.views.address(), drawn.params, drawn.depth.sampled(), image_.storage(), size, {}};
  fill_weights(radius, prefilter, arguments.weights);
  recorder.pass(name_ + "/convert", PassStage::build,
                {{drawn.depth, Use::compute_read}, {drawn.views, Use::compute_read}, {image_, Use::compute_write}},
                [&](Commands& commands) {
                  commands.bind(convert_);
                  commands.push(arguments);
                  const uint32_t columns = shape_.columns_of_group();
                  commands.dispatch(
                      glm::uvec3((size + columns - 1) / columns, (size + shape_.rows - 1) / shape_.rows, image_.info().layers));
                });
  if (history_ > 0.0f && drawn.last_views) record_history(recorder, drawn);
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
