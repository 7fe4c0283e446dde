// Culling of one view.
#include "frame/casters/culling/cull.h"

namespace gnomon {

Pipeline make_cull_pipeline(Device& device) { return make_compute_pipeline(device, "frame/casters/culling/cull.comp"); }

VkCullModeFlags bucket_cull_mode(uint32_t bucket) {
  if (bucket & Bucket::k_double_sided) return VK_CULL_MODE_NONE;
  return bucket & Bucket::k_mirrored ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT;
}

CulledDraws::CulledDraws(Device& device, const GpuScene& scene, const std::string& name)
    : scene_(&scene),
      draws_(device, name + " draws", scene.item_count() * sizeof(DrawCommand)),
      counts_(device, name + " draw counts", k_bucket_count * sizeof(uint32_t)) {}

void CulledDraws::record(Recorder& recorder, const Pipeline& cull_pipeline, const std::string& pass_name, PassStage stage,
                         uint64_t clip_from_world, uint32_t flags) {
  CullArguments arguments = {clip_from_world, scene_->items().address(), draws_.address(), counts_.address(), {}, flags};
  for (uint32_t b = 0; b < k_bucket_count; ++b) arguments.bucket_begin[b] = scene_->bucket(b).begin;
  arguments.bucket_begin[k_bucket_count] = scene_->item_count();
  recorder.pass(pass_name, stage, {{draws_, Use::compute_write}, {counts_, Use::compute_write}}, [&](Commands& commands) {
    commands.bind(cull_pipeline);
    commands.push(arguments);
    commands.dispatch_1d(k_bucket_count, 1);
  });
}

bool CulledDraws::draw_bucket(Commands& commands, uint32_t bucket) const {
  const Bucket& range = scene_->bucket(bucket);
  if (range.begin == range.end) return false;
  commands.draw_indirect(scene_->indices(), draws_, range.begin * sizeof(DrawCommand), counts_, bucket * sizeof(uint32_t),
                         range.end - range.begin);
  return true;
}

std::vector<ResourceUse> CulledDraws::uses() const { return {{draws_, Use::indirect_read}, {counts_, Use::indirect_read}}; }

}  // namespace gnomon
