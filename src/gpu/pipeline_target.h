// Graphics pipelines for other targets than those of the frame.
#pragma once

#include "gpu/pipeline.h"

namespace gnomon {

struct PipelineTarget {
  bool adds = false;                          // what fragments write is added to what is there
  VkRenderPass render_pass = VK_NULL_HANDLE;  // of code that is not gnomon's, one colour attachment; null: dynamic rendering
};

Pipeline make_graphics_pipeline(Device& device, const GraphicsPipelineInfo& info, const PipelineTarget& target);

}  // namespace gnomon
