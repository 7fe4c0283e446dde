// Acquire, copy, present. Pictures are sRGB-encoded already, so the images are of a UNORM format.
#include "app/viewer/window/swapchain.h"

#include <algorithm>

#include "app/viewer/window/interface.h"
#include "base/error.h"
#include "gpu/memory_barrier.h"

namespace gnomon::viewer {
namespace {

// A hidden window may give no image: the picture is then left out.
constexpr uint64_t k_patience_ns = 100'000'000;

VkSurfaceFormatKHR choose_format(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  uint32_t count = 0;
  vk_check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr), "vkGetPhysicalDeviceSurfaceFormatsKHR");
  std::vector<VkSurfaceFormatKHR> formats(count);
  vk_check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, formats.data()),
           "vkGetPhysicalDeviceSurfaceFormatsKHR");
  for (const VkFormat wanted : {k_window_format, VK_FORMAT_R8G8B8A8_UNORM}) {
    for (const VkSurfaceFormatKHR& format : formats) {
      if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return format;
    }
  }
  fail_device("the window offers no 8-bit UNORM format");
}

VkPresentModeKHR choose_mode(VkPhysicalDevice physical, VkSurfaceKHR surface, bool vsync) {
  uint32_t count = 0;
  vk_check(vkGetPhysicalDeviceSurfacePresentModesKHR(physical, surface, &count, nullptr),
           "vkGetPhysicalDeviceSurfacePresentModesKHR");
  std::vector<VkPresentModeKHR> modes(count);
  vk_check(vkGetPhysicalDeviceSurfacePresentModesKHR(physical, surface, &count, modes.data()),
           "vkGetPhysicalDeviceSurfacePresentModesKHR");
  for (const VkPresentModeKHR mode : {VK_PRESENT_MODE_MAILBOX_KHR, VK_PRESENT_MODE_IMMEDIATE_KHR}) {
    if (!vsync && std::find(modes.begin(), modes.end(), mode) != modes.end()) return mode;
  }
  return VK_PRESENT_MODE_FIFO_KHR;  // every device has it
}

VkImageMemoryBarrier2 barrier_of(VkImage image, const Transition& transition) {
  return image_barrier(image, VK_IMAGE_ASPECT_COLOR_BIT, transition);
}

void wait_for(VkCommandBuffer commands, std::initializer_list<VkImageMemoryBarrier2> barriers) {
  VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = static_cast<uint32_t>(barriers.size());
  dependency.pImageMemoryBarriers = barriers.begin();
  vkCmdPipelineBarrier2(commands, &dependency);
}

VkSemaphore make_semaphore(VkDevice device) {
  const VkSemaphoreCreateInfo info = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore semaphore = VK_NULL_HANDLE;
  vk_check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "vkCreateSemaphore");
  return semaphore;
}

}  // namespace

Swapchain::Swapchain(Device& device, const Window& window) : device_(device), window_(window) {
  surface_ = window.make_surface(device.instance());
  VkBool32 supported = VK_FALSE;
  vk_check(vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queue_family(), surface_, &supported),
           "vkGetPhysicalDeviceSurfaceSupportKHR");
  if (!supported) fail_device("'{}' cannot show pictures in this window", device.info().name);
  acquired_ = make_semaphore(device.handle());
  VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.queueFamilyIndex = device.queue_family();
  vk_check(vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_), "vkCreateCommandPool");
  VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool_;
  allocate.commandBufferCount = 1;
  vk_check(vkAllocateCommandBuffers(device.handle(), &allocate, &commands_), "vkAllocateCommandBuffers");
}

Swapchain::~Swapchain() {
  vkDeviceWaitIdle(device_.handle());
  destroy_images();
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  vkDestroyCommandPool(device_.handle(), pool_, nullptr);
  vkDestroySemaphore(device_.handle(), acquired_, nullptr);
  vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
}

void Swapchain::destroy_images() {
  for (const VkSemaphore semaphore : finished_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
  finished_.clear();
  images_.clear();
}

void Swapchain::set_vsync(bool on) {
  stale_ = stale_ || on != vsync_;
  vsync_ = on;
}

bool Swapchain::make() {
  VkSurfaceCapabilitiesKHR limits = {};
  vk_check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &limits),
           "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
  const uvec2 size = window_.size();
  extent_ = limits.currentExtent;
  if (extent_.width == UINT32_MAX) {  // the window takes the swapchain's size
    extent_.width = std::clamp(size.x, limits.minImageExtent.width, limits.maxImageExtent.width);
    extent_.height = std::clamp(size.y, limits.minImageExtent.height, limits.maxImageExtent.height);
  }
  if (extent_.width == 0 || extent_.height == 0) return false;
  if (!(limits.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT)) fail_device("the window's images cannot be copied to");

  const VkSurfaceFormatKHR format = choose_format(device_.physical(), surface_);
  VkSwapchainCreateInfoKHR info = {VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_;
  info.minImageCount = limits.minImageCount + 1;
  if (limits.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, limits.maxImageCount);
  info.imageFormat = format_ = format.format;
  info.imageColorSpace = format.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.preTransform = limits.currentTransform;
  const bool opaque = limits.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.compositeAlpha = opaque ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = choose_mode(device_.physical(), surface_, vsync_);
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;

  device_.wait_idle();
  destroy_images();
  VkSwapchainKHR made = VK_NULL_HANDLE;
  const VkResult result = vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made);
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  swapchain_ = made;
  vk_check(result, "vkCreateSwapchainKHR");
  uint32_t count = 0;
  vk_check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr), "vkGetSwapchainImagesKHR");
  images_.resize(count);
  vk_check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images_.data()), "vkGetSwapchainImagesKHR");
  for (uint32_t i = 0; i < count; ++i) finished_.push_back(make_semaphore(device_.handle()));
  stale_ = false;
  return true;
}

bool Swapchain::acquire(uint32_t& index) {
  // The window may change its size between any two calls; after a few tries this picture is left out.
  for (int attempt = 0; attempt < 3; ++attempt) {
    if (stale_ && !make()) return false;
    const VkResult result =
        vkAcquireNextImageKHR(device_.handle(), swapchain_, k_patience_ns, acquired_, VK_NULL_HANDLE, &index);
    if (result == VK_TIMEOUT || result == VK_NOT_READY) return false;
    stale_ = result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR;
    if (result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR) return true;
    if (!stale_) vk_check(result, "vkAcquireNextImageKHR");
  }
  return false;
}

void Swapchain::record_copy(const Image& picture, VkImage target) {
  vk_check(vkResetCommandPool(device_.handle(), pool_, 0), "vkResetCommandPool");
  VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  vk_check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  // From the stage that the acquisition is waited for in.
  const Transition to_copy = {true,
                              VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                              VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                              0,
                              VK_ACCESS_2_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_UNDEFINED,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
  wait_for(commands_, {barrier_of(picture.handle(), advance(picture.state(), Use::copy_read)), barrier_of(target, to_copy)});
  const ImageInfo& from = picture.info();
  if (format_ == from.format && extent_.width == from.width && extent_.height == from.height) {
    VkImageCopy region = {};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.extent = {from.width, from.height, 1};
    vkCmdCopyImage(commands_, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  } else {
    VkImageBlit region = {};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<int32_t>(from.width), static_cast<int32_t>(from.height), 1};
    region.dstOffsets[1] = {static_cast<int32_t>(extent_.width), static_cast<int32_t>(extent_.height), 1};
    vkCmdBlitImage(commands_, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_NEAREST);
  }
  wait_for(commands_, {barrier_of(target, {true, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                           VK_ACCESS_2_TRANSFER_WRITE_BIT, 0, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                           VK_IMAGE_LAYOUT_PRESENT_SRC_KHR})});
  vk_check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
}

void Swapchain::present(const Image& picture) {
  device_.wait(submitted_);  // the command buffer and the semaphore of the last picture are then free
  uint32_t index = 0;
  if (!acquire(index)) return;
  device_.begin_recording();
  record_copy(picture, images_[index]);
  submitted_ = device_.submit(commands_, acquired_, finished_[index]);
  device_.end_recording();

  VkPresentInfoKHR info = {VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &finished_[index];
  info.swapchainCount = 1;
  info.pSwapchains = &swapchain_;
  info.pImageIndices = &index;
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) {
    stale_ = true;
  } else {
    vk_check(result, "vkQueuePresentKHR");
  }
  device_.check_validation();
}

}  // namespace gnomon::viewer
