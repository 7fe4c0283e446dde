// The images that the window shows in turn.
#pragma once

#include <vector>

#include "app/viewer/window/window.h"
#include "gpu/image.h"

namespace gnomon::viewer {

class Swapchain {
 public:
  Swapchain(Device& device, const Window& window);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  // Shows a picture, in the window's size at that moment. Nothing happens while the window has no size.
  void present(const Image& picture);
  // On: a picture per refresh of the screen. Off: as many as can be drawn, where the device lets one.
  void set_vsync(bool on);
  bool vsync() const { return vsync_; }

 private:
  bool make();  // false while the window has no size
  void destroy_images();
  bool acquire(uint32_t& index);
  void record_copy(const Image& picture, VkImage target);

  Device& device_;
  const Window& window_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkExtent2D extent_ = {};
  VkFormat format_ = VK_FORMAT_UNDEFINED;
  std::vector<VkImage> images_;
  std::vector<VkSemaphore> finished_;  // one per image: free again when the image is
  VkSemaphore acquired_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  uint64_t submitted_ = 0;
  bool vsync_ = true, stale_ = true;
};

}  // namespace gnomon::viewer
