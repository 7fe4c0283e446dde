// Drawing casters from a light into one layer of a depth map.
#pragma once

#include "frame/cull.h"

namespace gnomon {

struct DepthPassPipelines {
  Pipeline opaque, masked;
};

// depth_clamp: casters before the near plane are drawn onto it instead of being lost.
DepthPassPipelines make_depth_pipelines(Device& device, bool depth_clamp);

// One pass: clears the layer to 1 (nothing nearer) and draws the culled casters. `view`: device address of clip_from_world.
// front_face_culling: only the faces turned away from the light are drawn, except of alpha-tested casters, which are often
// single sheets.
void record_depth_pass(Recorder& recorder, const std::string& name, const GpuScene& scene, const DepthPassPipelines& pipelines,
                       const CulledDraws& draws, const Image& map, uint32_t layer, uint64_t view, bool front_face_culling);

}  // namespace gnomon
