// Staging copy and blits.
#include "frame/texture_upload.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "gpu/recorder.h"

namespace gnomon {
namespace {

void mip_barrier(VkCommandBuffer commands, VkImage image, uint32_t first, uint32_t count, VkImageLayout from,
                 VkImageLayout to) {
  VkImageMemoryBarrier2 barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, first, count, 0, 1};
  VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

Image upload_texture(Device& device, const Texture& texture) {
  const auto width = static_cast<uint32_t>(texture.image.width), height = static_cast<uint32_t>(texture.image.height);
  ImageInfo info;
  info.name = "texture " + texture.name;
  info.width = width, info.height = height;
  info.material = true;
  info.format = texture.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  info.mips = static_cast<uint32_t>(std::bit_width(std::max(width, height)));
  Image image(device, info);
  const Buffer staging(device, "staging for " + info.name, texture.image.rgba.size(), BufferMemory::upload);
  std::memcpy(staging.mapped(), texture.image.rgba.data(), texture.image.rgba.size());
  staging.flush();
  run_once(device, [&](VkCommandBuffer commands) {
    mip_barrier(commands, image.handle(), 0, info.mips, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy copy = {};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {width, height, 1};
    vkCmdCopyBufferToImage(commands, staging.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    for (uint32_t mip = 1; mip < info.mips; ++mip) {
      mip_barrier(commands, image.handle(), mip - 1, 1, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                  VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
      const auto extent = [&](uint32_t level) {
        return VkOffset3D{static_cast<int32_t>(std::max(width >> level, 1u)),
                          static_cast<int32_t>(std::max(height >> level, 1u)), 1};
      };
      VkImageBlit blit = {};
      blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, 1};
      blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1};
      blit.srcOffsets[1] = extent(mip - 1);
      blit.dstOffsets[1] = extent(mip);
      vkCmdBlitImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.handle(),
                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    }
    if (info.mips > 1) {
      mip_barrier(commands, image.handle(), 0, info.mips - 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                  VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL);
    }
    mip_barrier(commands, image.handle(), info.mips - 1, 1, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL);
  });
  return image;
}

}  // namespace gnomon
