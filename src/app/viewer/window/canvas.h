// What the window shows: one picture or two beside each other, stretched to the window's size, and the interface on top of
// them.
#pragma once

#include <array>

#include "frame/frame.h"
#include "gpu/recorder.h"

namespace gnomon::viewer {

class Interface;

class Canvas {
 public:
  explicit Canvas(Device& device) : device_(device) {}
  ~Canvas() { release(); }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void resize(uvec2 size, VkRenderPass render_pass);
  // Keeps the frame's picture as that of a side: 0 is on the left.
  void record_picture(Recorder& recorder, const Frame& frame, size_t side);
  // Side 0 on the first `divider` of the window's width, side 1 on the rest: [0, 1].
  // `shown`: what the interface reads beside its font.
  void record_window(Recorder& recorder, float divider, Interface& interface, std::span<const ResourceUse> shown);
  void record_empty(Recorder& recorder, Interface& interface);  // where there is no picture yet
  const Image& image() const { return image_; }
  uvec2 size() const { return {image_.info().width, image_.info().height}; }
  Image8 read() const;  // of the last finished frame

 private:
  void stretch(const Commands& commands, const Image& picture, uint32_t from_x, uint32_t to_x) const;
  void record_interface(Recorder& recorder, Interface& interface, std::span<const ResourceUse> shown);
  void release() noexcept;

  Device& device_;
  std::array<Image, 2> pictures_;  // of the sides, each in its own size
  Image image_;
  VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

}  // namespace gnomon::viewer
