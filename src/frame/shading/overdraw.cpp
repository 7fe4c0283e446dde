// The surface pass again, adding ones.
#include "frame/shading/overdraw.h"

#include "gpu/pipeline_target.h"

namespace gnomon {
namespace {

Image make_image(Device& device, const char* name, uvec2 size, VkFormat format, VkImageUsageFlags usage) {
  ImageInfo info;
  info.name = name;
  info.width = size.x, info.height = size.y;
  info.format = format;
  info.usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT;
  return Image(device, info);
}

}  // namespace

Overdraw::Overdraw(Device& device, uvec2 size)
    : count_(make_image(device, "overdraw", size, VK_FORMAT_R16_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT)),
      depth_(make_image(device, "overdraw depth", size, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)) {
  GraphicsPipelineInfo info;
  info.vertex = "frame/surface/surface.vert";
  info.fragment = "frame/shading/overdraw.frag";
  info.colour_formats = {count_.info().format};
  pipeline_ = make_graphics_pipeline(device, info, {.adds = true});
}

void Overdraw::record(Recorder& recorder, const Frame& frame) {
  const CulledDraws& draws = frame.camera_draws();
  std::vector<ResourceUse> uses = draws.uses();
  uses.emplace_back(count_, Use::colour_write);
  uses.emplace_back(depth_, Use::depth_write);
  recorder.pass("explain/overdraw", PassStage::other, uses, [&](Commands& commands) {
    const Attachment counts[] = {{count_.layer_view(0), {}}};
    commands.begin_rendering(size(), counts, {depth_.layer_view(0), {.depthStencil = {0.0f, 0}}});
    commands.bind(pipeline_);
    commands.push(frame.data_address());
    for (uint32_t bucket = 0; bucket < k_bucket_count; ++bucket) {
      commands.cull_mode(bucket_cull_mode(bucket));
      draws.draw_bucket(commands, bucket);
    }
    commands.end_rendering();
  });
}

}  // namespace gnomon
