// The blend, and the copy into the depth map.
#include "shadow/map/depth_history.h"

#include "frame/surface/pixel_tile.glsl"

namespace gnomon {

DepthHistory::DepthHistory(Device& device, const MapInfo& map) : name_(map.name), history_(map.history) {
  const size_t bytes = sizeof(float) * map.size * map.size * map.layers;
  last_ = Buffer(device, map.name + " last depths", bytes);
  blended_ = Buffer(device, map.name + " blended depths", bytes);
  pipeline_ = make_compute_pipeline(device, "shadow/map/depth_history.comp");
}

void DepthHistory::record(Recorder& recorder, const DrawnMap& map) {
  std::swap(last_, blended_);
  struct Arguments {
    uint64_t views, last_views, last, blended;
    uint32_t depth_image, size;
    float history;
  };
  const ImageInfo& info = map.depth.info();
  const Buffer& last_views = map.last_views ? *map.last_views : map.views;
  const Arguments arguments = {map.views.address(),
                               last_views.address(),
                               last_.address(),
                               blended_.address(),
                               map.depth.sampled(),
                               info.width,
                               map.last_views ? history_ : 0.0f};
  std::vector<ResourceUse> uses = {{map.depth, Use::compute_read},
                                   {map.views, Use::compute_read},
                                   {last_, Use::compute_read},
                                   {blended_, Use::compute_write}};
  if (map.last_views) uses.emplace_back(last_views, Use::compute_read);
  recorder.pass(name_ + "/temporal", PassStage::build, uses, [&](Commands& commands) {
    commands.bind(pipeline_);
    commands.push(arguments);
    const uint32_t tiles = (info.width + k_pixel_tile - 1) / k_pixel_tile;
    commands.dispatch(glm::uvec3(tiles, tiles, info.layers));
  });
  recorder.pass(name_ + "/temporal_copy", PassStage::build, {{blended_, Use::copy_read}, {map.depth, Use::copy_write}},
                [&](Commands& commands) { commands.copy(blended_, map.depth); });
}

}  // namespace gnomon
