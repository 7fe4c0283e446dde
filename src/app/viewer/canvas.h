// What the window shows: the frame's picture, stretched to the window's size, and the interface on top of it.
#pragma once

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
  void record(Recorder& recorder, const Frame& frame, Interface& interface);
  void record_empty(Recorder& recorder, Interface& interface);  // where there is no frame yet
  const Image& image() const { return image_; }
  uvec2 size() const { return {image_.info().width, image_.info().height}; }
  Image8 read() const;  // of the last finished frame

 private:
  void record_interface(Recorder& recorder, Interface& interface);
  void release() noexcept;

  Device& device_;
  Image picture_;  // the frame's, in its own size
  Image image_;
  VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

}  // namespace gnomon::viewer
