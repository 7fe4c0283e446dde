// Dear ImGui: its context, its link to the window and to the device.
#pragma once

#include "app/viewer/window/window.h"

namespace gnomon::viewer {

// What it is drawn onto: as most windows have it, so that a finished picture needs a copy only.
inline constexpr VkFormat k_window_format = VK_FORMAT_B8G8R8A8_UNORM;

class Interface {
 public:
  Interface(Device& device, const Window& window);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  VkRenderPass render_pass() const { return render_pass_; }
  // Panels are written between the two.
  void begin_frame();
  void end_frame();
  // Draws them onto the image of a framebuffer, which is and stays in ATTACHMENT_OPTIMAL.
  void draw(VkCommandBuffer commands, VkFramebuffer framebuffer, uvec2 size);

  // The list or popup that was opened last; nothing where none is open.
  void close_popup();

  // Whether a text field or a panel takes the keys or the mouse, so that the camera does not.
  bool takes_keys() const;
  bool takes_mouse() const;
  float wheel() const;

 private:
  void make_render_pass();

  Device& device_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkRenderPass render_pass_ = VK_NULL_HANDLE;
};

}  // namespace gnomon::viewer
