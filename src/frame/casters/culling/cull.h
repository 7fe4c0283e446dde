// Culling of one view in compute, and the draws that it leaves.
#pragma once

#include "frame/gpu_scene.h"
#include "gpu/pipeline.h"
#include "gpu/recorder.h"

namespace gnomon {

class CulledDraws {
 public:
  CulledDraws() = default;
  CulledDraws(Device& device, const GpuScene& scene, const std::string& name);

  // Adds one pass that fills the draw commands. `clip_from_world`: device address of the view's mat4. flags: k_cull_*.
  void record(Recorder& recorder, const Pipeline& cull_pipeline, const std::string& pass_name, PassStage stage,
              uint64_t clip_from_world, uint32_t flags);
  // Inside a rendering scope: draws one bucket with the bound pipeline. False where the scene has no item in it.
  bool draw_bucket(Commands& commands, uint32_t bucket) const;
  // What a pass that draws must name.
  std::vector<ResourceUse> uses() const;

 private:
  const GpuScene* scene_ = nullptr;
  Buffer draws_, counts_;
};

Pipeline make_cull_pipeline(Device& device);

// The faces that the camera does not see of a bucket's surfaces.
VkCullModeFlags bucket_cull_mode(uint32_t bucket);

}  // namespace gnomon
