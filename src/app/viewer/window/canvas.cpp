// Copy, stretch, interface: passes behind those of the frame.
#include "app/viewer/window/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/viewer/window/interface.h"

namespace gnomon::viewer {
namespace {

Image make_image(Device& device, const char* name, uvec2 size, VkFormat format) {
  ImageInfo info;
  info.name = name;
  info.width = size.x, info.height = size.y;
  info.format = format;
  // An image has a view, and a view needs more than copies: hence an attachment.
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return Image(device, info);
}

}  // namespace

void Canvas::resize(uvec2 size, VkRenderPass render_pass) {
  release();
  image_ = make_image(device_, "canvas", size, k_window_format);
  const VkImageView view = image_.layer_view(0);
  VkFramebufferCreateInfo info = {VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
  info.renderPass = render_pass;
  info.attachmentCount = 1;
  info.pAttachments = &view;
  info.width = size.x, info.height = size.y;
  info.layers = 1;
  device_.reserve_defer();
  vk_check(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffer_), "vkCreateFramebuffer");
}

void Canvas::release() noexcept {
  if (!framebuffer_) return;
  device_.defer(
      [device = device_.handle(), framebuffer = framebuffer_] { vkDestroyFramebuffer(device, framebuffer, nullptr); });
  framebuffer_ = VK_NULL_HANDLE;
}

void Canvas::record_picture(Recorder& recorder, const Frame& frame, size_t side) {
  Image& picture = pictures_[side];
  const uvec2 from = frame.size();
  if (!picture || from != uvec2(picture.info().width, picture.info().height)) {
    picture = make_image(device_, "picture", from, VK_FORMAT_R8G8B8A8_UNORM);
  }
  recorder.pass("window/copy", PassStage::other, {{frame.display(), Use::copy_read}, {picture, Use::copy_write}},
                [&](Commands& commands) { commands.copy(frame.display(), picture); });
}

// The part of a picture that lies between two columns of the window.
void Canvas::stretch(const Commands& commands, const Image& picture, uint32_t from_x, uint32_t to_x) const {
  const uvec2 from(picture.info().width, picture.info().height);
  const auto picture_x = [&](uint32_t x) {
    return static_cast<int32_t>(std::lround(static_cast<double>(x) * from.x / size().x));
  };
  VkImageBlit region = {};
  region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.srcOffsets[0] = {picture_x(from_x), 0, 0};
  region.srcOffsets[1] = {picture_x(to_x), static_cast<int32_t>(from.y), 1};
  region.dstOffsets[0] = {static_cast<int32_t>(from_x), 0, 0};
  region.dstOffsets[1] = {static_cast<int32_t>(to_x), static_cast<int32_t>(size().y), 1};
  if (from_x == to_x || region.srcOffsets[0].x == region.srcOffsets[1].x) return;
  // Of the same size: the same bits.
  vkCmdBlitImage(commands.handle(), picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image_.handle(),
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, from == size() ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
}

void Canvas::record_window(Recorder& recorder, float divider, Interface& interface, std::span<const ResourceUse> shown) {
  const auto split = static_cast<uint32_t>(std::lround(std::clamp(divider, 0.0f, 1.0f) * static_cast<float>(size().x)));
  std::vector<ResourceUse> uses = {{image_, Use::copy_write}};
  for (const Image& picture : pictures_) {
    if (picture) uses.emplace_back(picture, Use::copy_read);
  }
  recorder.pass("window/stretch", PassStage::other, uses, [&](Commands& commands) {
    if (pictures_[0]) stretch(commands, pictures_[0], 0, split);
    if (pictures_[1]) stretch(commands, pictures_[1], split, size().x);
  });
  record_interface(recorder, interface, shown);
}

void Canvas::record_empty(Recorder& recorder, Interface& interface) {
  recorder.pass("window/clear", PassStage::other, {{image_, Use::copy_write}}, [&](Commands& commands) {
    const VkClearColorValue dark = {{0.08f, 0.08f, 0.09f, 1.0f}};
    const VkImageSubresourceRange all = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands.handle(), image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark, 1, &all);
  });
  record_interface(recorder, interface, {});
}

void Canvas::record_interface(Recorder& recorder, Interface& interface, std::span<const ResourceUse> shown) {
  std::vector<ResourceUse> uses(shown.begin(), shown.end());
  uses.emplace_back(image_, Use::colour_write);
  recorder.pass("window/interface", PassStage::other, uses,
                [&](Commands& commands) { interface.draw(commands.handle(), framebuffer_, size()); });
}

Image8 Canvas::read() const {
  const size_t bytes = size_t{size().x} * size().y * 4;
  const Buffer staging(device_, "readback of the canvas", bytes, BufferMemory::readback);
  Recorder recorder(device_, TimingMode::play, false);
  recorder.begin();
  recorder.pass("window/read", PassStage::other, {{image_, Use::copy_read}, {staging, Use::copy_write}},
                [&](Commands& commands) {
                  VkBufferImageCopy region = {};
                  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
                  region.imageExtent = {size().x, size().y, 1};
                  vkCmdCopyImageToBuffer(commands.handle(), image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                         staging.handle(), 1, &region);
                });
  recorder.finish();
  staging.invalidate();
  Image8 image(static_cast<int>(size().x), static_cast<int>(size().y));
  std::memcpy(image.rgba.data(), staging.mapped(), bytes);
  static_assert(k_window_format == VK_FORMAT_B8G8R8A8_UNORM);
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    std::swap(image.rgba[i], image.rgba[i + 2]);
    image.rgba[i + 3] = 255;  // blending left its own
  }
  return image;
}

}  // namespace gnomon::viewer
