// Barriers as Vulkan takes them: of all memory, and of an image.
#pragma once

#include "gpu/use.h"

namespace gnomon {

// One global memory barrier: what `from` wrote is made available to `to`.
inline void memory_barrier(VkCommandBuffer commands, VkPipelineStageFlags2 from_stages, VkAccessFlags2 from_access,
                           VkPipelineStageFlags2 to_stages, VkAccessFlags2 to_access) {
  VkMemoryBarrier2 barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = from_stages;
  barrier.srcAccessMask = from_access;
  barrier.dstStageMask = to_stages;
  barrier.dstAccessMask = to_access;
  VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

// Of all mips and layers.
inline VkImageMemoryBarrier2 image_barrier(VkImage image, VkImageAspectFlags aspect, const Transition& transition) {
  VkImageMemoryBarrier2 barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = transition.from_stages;
  barrier.srcAccessMask = transition.from_access;
  barrier.dstStageMask = transition.to_stages;
  barrier.dstAccessMask = transition.to_access;
  barrier.oldLayout = transition.from_layout;
  barrier.newLayout = transition.to_layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  return barrier;
}

}  // namespace gnomon
