// Drawing casters from a light.
#include "frame/depth_pass.h"

namespace gnomon {

DepthPassPipelines make_depth_pipelines(Device& device, bool depth_clamp) {
  GraphicsPipelineInfo info;
  info.depth_compare = VK_COMPARE_OP_LESS;
  info.depth_clamp = depth_clamp;
  DepthPassPipelines pipelines;
  info.vertex = "frame/depth_opaque.vert";
  pipelines.opaque = make_graphics_pipeline(device, info);
  info.vertex = "frame/depth.vert";
  info.fragment = "frame/depth_masked.frag";
  pipelines.masked = make_graphics_pipeline(device, info);
  return pipelines;
}

void record_depth_pass(Recorder& recorder, const std::string& name, const GpuScene& scene, const DepthPassPipelines& pipelines,
                       const CulledDraws& draws, const Image& map, uint32_t layer, uint64_t view, bool front_face_culling) {
  struct Arguments {
    uint64_t view;
    SceneData scene;
  };
  std::vector<ResourceUse> uses = draws.uses();
  uses.emplace_back(map, Use::depth_write);
  recorder.pass(name, PassStage::build, uses, [&](Commands& commands) {
    Attachment depth;
    depth.view = map.layer_view(layer);
    depth.clear.depthStencil = {1.0f, 0};
    commands.begin_rendering({map.info().width, map.info().height}, {}, depth);
    for (const bool masked : {false, true}) {
      commands.bind(masked ? pipelines.masked : pipelines.opaque);
      commands.push(Arguments{view, scene.data()});
      for (uint32_t bucket = 0; bucket < k_bucket_count; ++bucket) {
        if (((bucket & Bucket::k_masked) != 0) != masked) continue;
        const VkCullModeFlags front = bucket & Bucket::k_mirrored ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_FRONT_BIT;
        commands.cull_mode(front_face_culling && !masked ? front : VkCullModeFlags{VK_CULL_MODE_NONE});
        draws.draw_bucket(commands, bucket);
      }
    }
    commands.end_rendering();
  });
}

}  // namespace gnomon
