// Copy, stretch, interface: passes behind those of the frame.
#include "app/viewer/canvas.h"

#include <cstring>

#include "app/viewer/interface.h"

namespace gnomon::viewer {
namespace {

Image make_image(Device& device, const char* name, uvec2 size) {
  ImageInfo info;
  info.name = name;
  info.width = size.x, info.height = size.y;
  // An image has a view, and a view needs more than copies: hence an attachment.
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return Image(device, info);
}

}  // namespace

void Canvas::resize(uvec2 size, VkRenderPass render_pass) {
  release();
  image_ = make_image(device_, "canvas", size);
  const VkImageView view = image_.layer_view(0);
  VkFramebufferCreateInfo info = {VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
  info.renderPass = render_pass;
  info.attachmentCount = 1;
  info.pAttachments = &view;
  info.width = size.x, info.height = size.y;
  info.layers = 1;
  vk_check(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffer_), "vkCreateFramebuffer");
}

void Canvas::release() noexcept {
  if (!framebuffer_) return;
  device_.defer([device = device_.handle(), framebuffer = framebuffer_] { vkDestroyFramebuffer(device, framebuffer, nullptr); });
  framebuffer_ = VK_NULL_HANDLE;
}

void Canvas::record(Recorder& recorder, const Frame& frame, Interface& interface) {
  const uvec2 from = frame.size();
  if (!picture_ || from != uvec2(picture_.info().width, picture_.info().height)) picture_ = make_image(device_, "picture", from);
  recorder.pass("window/copy", PassStage::other, {{frame.display(), Use::copy_read}, {picture_, Use::copy_write}},
                [&](Commands& commands) { commands.copy(frame.display(), picture_); });
  recorder.pass("window/stretch", PassStage::other, {{picture_, Use::copy_read}, {image_, Use::copy_write}}, [&](Commands& commands) {
    VkImageBlit region = {};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<int32_t>(from.x), static_cast<int32_t>(from.y), 1};
    region.dstOffsets[1] = {static_cast<int32_t>(size().x), static_cast<int32_t>(size().y), 1};
    // Of the same size: the same bits.
    vkCmdBlitImage(commands.handle(), picture_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image_.handle(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, from == size() ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
  });
  record_interface(recorder, interface);
}

void Canvas::record_empty(Recorder& recorder, Interface& interface) {
  recorder.pass("window/clear", PassStage::other, {{image_, Use::copy_write}}, [&](Commands& commands) {
    const VkClearColorValue dark = {{0.08f, 0.08f, 0.09f, 1.0f}};
    const VkImageSubresourceRange all = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands.handle(), image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark, 1, &all);
  });
  record_interface(recorder, interface);
}

void Canvas::record_interface(Recorder& recorder, Interface& interface) {
  recorder.pass("window/interface", PassStage::other, {{image_, Use::colour_write}},
                [&](Commands& commands) { interface.draw(commands.handle(), framebuffer_, size()); });
}

Image8 Canvas::read() const {
  const size_t bytes = size_t{size().x} * size().y * 4;
  const Buffer staging(device_, "readback of the canvas", bytes, BufferMemory::readback);
  Recorder recorder(device_, TimingMode::play, false);
  recorder.begin();
  recorder.pass("window/read", PassStage::other, {{image_, Use::copy_read}, {staging, Use::copy_write}}, [&](Commands& commands) {
    VkBufferImageCopy region = {};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {size().x, size().y, 1};
    vkCmdCopyImageToBuffer(commands.handle(), image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.handle(), 1, &region);
  });
  recorder.finish();
  staging.invalidate();
  Image8 image(static_cast<int>(size().x), static_cast<int>(size().y));
  std::memcpy(image.rgba.data(), staging.mapped(), bytes);
  for (size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;  // blending left its own alpha
  return image;
}

}  // namespace gnomon::viewer
