// A 2D image or array: move-only, named at creation, with its place in the bindless set.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/use.h"

struct VmaAllocation_T;

namespace gnomon {

struct ImageInfo {
  std::string name;
  uint32_t width = 1, height = 1;
  VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  uint32_t layers = 1;
  uint32_t mips = 1;
  uint32_t samples = 1;
  bool array = false;     // sampled as an array even with one layer
  bool material = false;  // belongs to a scene: goes into the first descriptor set (gpu/bindless.h)
};

class Image {
 public:
  static constexpr uint32_t k_no_index = 0xffffffffu;

  Image() = default;
  // Throws Error when the format cannot be used that way, the size exceeds the device's limit, or memory is used up.
  Image(Device& device, const ImageInfo& info);
  ~Image() { release(); }
  Image(Image&& other) noexcept { swap(other); }
  Image& operator=(Image&& other) noexcept {
    if (this != &other) release(), swap(other);
    return *this;
  }

  explicit operator bool() const { return image_ != VK_NULL_HANDLE; }
  VkImage handle() const { return image_; }
  VkImageView view() const { return view_; }                                    // all layers and mips
  VkImageView layer_view(uint32_t layer) const { return layer_views_[layer]; }  // mip 0, as an attachment
  VkImageView attachment_view() const { return attachment_view_; }              // the same of all layers
  const ImageInfo& info() const { return info_; }
  VkImageAspectFlags aspect() const;
  uint32_t sampled() const { return sampled_; }  // index for texture2D (MS, array) in the bindless set
  // Index for storage images in the bindless set; array images are arrays there too.
  uint32_t storage(uint32_t mip = 0) const { return storages_[mip]; }
  ResourceState& state() const { return *state_; }
  // For a recorder, which takes the state back where what it recorded is never submitted; the resource may be gone by then.
  const std::shared_ptr<ResourceState>& shared_state() const { return state_; }

 private:
  void create_views();
  void release() noexcept;
  void swap(Image& other) noexcept;

  Device* device_ = nullptr;
  ImageInfo info_;
  VkImage image_ = VK_NULL_HANDLE;
  VmaAllocation_T* allocation_ = nullptr;
  VkDeviceSize bytes_ = 0;
  VkImageView view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> layer_views_;
  VkImageView attachment_view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> part_views_;  // every view but view_, for destruction
  uint32_t sampled_ = k_no_index;
  std::vector<uint32_t> storages_;  // one per mip
  std::shared_ptr<ResourceState> state_;
};

}  // namespace gnomon
