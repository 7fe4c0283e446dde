// What may be recorded inside a pass.
#include "base/error.h"
#include "gpu/memory_barrier.h"
#include "gpu/recorder.h"

namespace gnomon {

void Commands::bind(const Pipeline& pipeline) {
  vkCmdBindPipeline(commands_, pipeline.bind_point(), pipeline.handle());
  const auto& sets = device_->bindless().sets();
  vkCmdBindDescriptorSets(commands_, pipeline.bind_point(), device_->pipeline_layout(), 0, 2, sets.data(), 0, nullptr);
}

void Commands::push_bytes(std::span<const std::byte> bytes) {
  GNOMON_ASSERT(bytes.size() <= Bindless::k_push_constant_bytes && bytes.size() % 4 == 0);
  vkCmdPushConstants(commands_, device_->pipeline_layout(), VK_SHADER_STAGE_ALL, 0, static_cast<uint32_t>(bytes.size()),
                     bytes.data());
}

void Commands::dispatch(uvec2 count, uvec2 group) {
  vkCmdDispatch(commands_, (count.x + group.x - 1) / group.x, (count.y + group.y - 1) / group.y, 1);
  ++dispatches_;
}

void Commands::dispatch(glm::uvec3 groups) {
  vkCmdDispatch(commands_, groups.x, groups.y, groups.z);
  ++dispatches_;
}

void Commands::compute_barrier() {
  memory_barrier(commands_, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
                 VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT);
}

void Commands::dispatch_1d(uint32_t count, uint32_t group) { dispatch({count, 1}, {group, 1}); }

void Commands::begin_rendering(uvec2 size, std::span<const Attachment> colours, const Attachment& depth, uint32_t layers,
                               uint32_t view_mask) {
  const auto attachment_info = [](const Attachment& attachment) {
    VkRenderingAttachmentInfo info = {VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = attachment.view;
    info.imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = attachment.clear;
    return info;
  };
  std::vector<VkRenderingAttachmentInfo> colour_infos;
  for (const auto& colour : colours) colour_infos.push_back(attachment_info(colour));
  const VkRenderingAttachmentInfo depth_info = attachment_info(depth);
  VkRenderingInfo info = {VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = {size.x, size.y};
  info.layerCount = layers;
  info.viewMask = view_mask;
  info.colorAttachmentCount = static_cast<uint32_t>(colour_infos.size());
  info.pColorAttachments = colour_infos.data();
  info.pDepthAttachment = &depth_info;
  vkCmdBeginRendering(commands_, &info);
  const VkViewport viewport = {0.0f, 0.0f, static_cast<float>(size.x), static_cast<float>(size.y), 0.0f, 1.0f};
  const VkRect2D scissor = {{0, 0}, {size.x, size.y}};
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &scissor);
  vkCmdSetCullMode(commands_, VK_CULL_MODE_NONE);
}

void Commands::end_rendering() { vkCmdEndRendering(commands_); }

void Commands::cull_mode(VkCullModeFlags mode) { vkCmdSetCullMode(commands_, mode); }

void Commands::draw_indirect(const Buffer& indices, const Buffer& draws, size_t draws_offset, const Buffer& counts,
                             size_t count_offset, uint32_t max_draws) {
  vkCmdBindIndexBuffer(commands_, indices.handle(), 0, VK_INDEX_TYPE_UINT32);
  vkCmdDrawIndexedIndirectCount(commands_, draws.handle(), draws_offset, counts.handle(), count_offset, max_draws,
                                sizeof(VkDrawIndexedIndirectCommand));
  count_reads_.push_back({&counts, count_offset});
}

void Commands::trace(const RayPipeline& pipeline, uvec2 size) {
  bind(pipeline.pipeline());
  pipeline.trace(commands_, size.x, size.y);
  ++dispatches_;
}

void Commands::copy(const Buffer& from, const Buffer& to, size_t bytes, size_t from_offset, size_t to_offset) {
  const VkBufferCopy region = {from_offset, to_offset, bytes};
  vkCmdCopyBuffer(commands_, from.handle(), to.handle(), 1, &region);
}

void Commands::copy(const Buffer& from, const Image& to) {
  VkBufferImageCopy region = {};
  region.imageSubresource = {to.aspect(), 0, 0, to.info().layers};
  region.imageExtent = {to.info().width, to.info().height, 1};
  vkCmdCopyBufferToImage(commands_, from.handle(), to.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

}  // namespace gnomon
