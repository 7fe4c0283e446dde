// How a pass uses a resource: one word that stands for pipeline stages, accesses and an image layout.
#pragma once

#include "gpu/vulkan.h"

namespace gnomon {

enum class Use {
  compute_read,   // buffers and sampled images in compute
  compute_write,  // buffers and storage images in compute; may also read
  graphics_read,  // buffers in vertex and fragment shaders
  sampled,        // images in fragment shaders
  colour_write,   // colour attachment
  depth_write,    // depth attachment, tested and written
  indirect_read,  // indirect commands and counts (also copied, for the draw statistics)
  copy_read,
  copy_write,
  ray_read,     // buffers and sampled images in ray-tracing shaders
  ray_write,    // buffers in ray-tracing shaders
  build_read,   // vertices, indices, instances of an acceleration-structure build
  build_write,  // acceleration structure and scratch of a build
};

struct UseInfo {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
  VkImageLayout layout;  // of images; UNDEFINED for uses that only buffers have
  bool writes;
};

UseInfo use_info(Use use);

// What the GPU did last with a resource, so that the next use can wait for exactly that.
struct ResourceState {
  VkPipelineStageFlags2 write_stages = 0;
  VkAccessFlags2 write_access = 0;
  VkPipelineStageFlags2 visible_stages = 0;  // readers that already wait for the last write
  VkAccessFlags2 visible_access = 0;
  VkPipelineStageFlags2 read_stages = 0;  // readers since the last write
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

// The barrier from `state` to `use`, and the state after it. `needed` is false when nothing must be waited for.
struct Transition {
  bool needed;
  VkPipelineStageFlags2 from_stages, to_stages;
  VkAccessFlags2 from_access, to_access;
  VkImageLayout from_layout, to_layout;
};
Transition advance(ResourceState& state, Use use);

}  // namespace gnomon
