// Images from VMA, their views and bindless indices.
#include "gpu/image.h"

#include <vk_mem_alloc.h>

#include <algorithm>

#include "base/error.h"

namespace gnomon {

Image::Image(Device& device, const ImageInfo& info) : device_(&device), info_(info), state_(std::make_shared<ResourceState>()) {
  VkImageFormatProperties limits = {};
  const VkResult supported = vkGetPhysicalDeviceImageFormatProperties(device.physical(), info.format, VK_IMAGE_TYPE_2D,
                                                                      VK_IMAGE_TILING_OPTIMAL, info.usage, 0, &limits);
  const std::string what = fmt::format("image '{}' ({} x {}, {} layers)", info.name, info.width, info.height, info.layers);
  if (supported == VK_ERROR_FORMAT_NOT_SUPPORTED || !(limits.sampleCounts & info.samples)) {
    fail_device("{}: the device cannot use format {} with {} samples this way", what, static_cast<int>(info.format),
                info.samples);
  }
  vk_check(supported, "vkGetPhysicalDeviceImageFormatProperties");
  if (info.width > limits.maxExtent.width || info.height > limits.maxExtent.height || info.layers > limits.maxArrayLayers) {
    fail_device("{}: the device's limit is {} x {}, {} layers", what, limits.maxExtent.width, limits.maxExtent.height,
                limits.maxArrayLayers);
  }

  VkImageCreateInfo create = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  create.imageType = VK_IMAGE_TYPE_2D;
  create.format = info.format;
  create.extent = {info.width, info.height, 1};
  create.mipLevels = info.mips;
  create.arrayLayers = info.layers;
  create.samples = static_cast<VkSampleCountFlagBits>(info.samples);
  create.usage = info.usage;
  // Asking the driver for more than there is, is an error of usage: known beforehand, it is one message.
  VkDeviceImageMemoryRequirements query = {VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS};
  query.pCreateInfo = &create;
  VkMemoryRequirements2 needed = {VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vkGetDeviceImageMemoryRequirements(device.handle(), &query, &needed);
  const VkDeviceSize most = std::min<VkDeviceSize>(device.info().memory_bytes, limits.maxResourceSize);
  if (needed.memoryRequirements.size > most) {
    fail("{} needs {} MiB: the device gives an image at most {}", what, needed.memoryRequirements.size >> 20, most >> 20);
  }

  VmaAllocationCreateInfo allocation = {};
  allocation.usage = VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE;
  VmaAllocationInfo result = {};
  device.reserve_defer();
  const VkResult created = vmaCreateImage(device.allocator(), &create, &allocation, &image_, &allocation_, &result);
  if (created != VK_SUCCESS) {
    image_ = VK_NULL_HANDLE;
    vk_check(created, what);
  }
  bytes_ = result.size;
  device.note_allocation(static_cast<int64_t>(bytes_));
  device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(image_), info.name);
  try {
    create_views();
  } catch (...) {
    release();  // no destructor runs for an object that was not made
    throw;
  }
}

VkImageAspectFlags Image::aspect() const {
  return info_.format == VK_FORMAT_D32_SFLOAT || info_.format == VK_FORMAT_D16_UNORM ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                                     : VK_IMAGE_ASPECT_COLOR_BIT;
}

void Image::create_views() {
  const bool array = info_.array || info_.layers > 1;
  VkImageViewCreateInfo view = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image_;
  view.viewType = array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
  view.format = info_.format;
  view.subresourceRange = {aspect(), 0, info_.mips, 0, info_.layers};
  vk_check(vkCreateImageView(device_->handle(), &view, nullptr, &view_), "vkCreateImageView");
  const auto make = [&](VkImageViewType type, uint32_t mip, uint32_t layer, uint32_t layers) {
    view.viewType = type;
    view.subresourceRange = {aspect(), mip, 1, layer, layers};
    part_views_.push_back(VK_NULL_HANDLE);
    vk_check(vkCreateImageView(device_->handle(), &view, nullptr, &part_views_.back()), "vkCreateImageView");
    return part_views_.back();
  };
  const VkImageViewType whole = view.viewType;
  if (info_.usage & (VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)) {
    for (uint32_t layer = 0; layer < info_.layers; ++layer) layer_views_.push_back(make(VK_IMAGE_VIEW_TYPE_2D, 0, layer, 1));
    attachment_view_ = make(whole, 0, 0, info_.layers);
  }
  const auto sampled_kind = info_.material ? Bindless::Kind::material : Bindless::Kind::frame;
  if (info_.usage & VK_IMAGE_USAGE_SAMPLED_BIT) sampled_ = device_->bindless().add(sampled_kind, view_);
  if (info_.usage & VK_IMAGE_USAGE_STORAGE_BIT) {
    storages_.reserve(info_.mips);
    for (uint32_t mip = 0; mip < info_.mips; ++mip) {
      storages_.push_back(device_->bindless().add(Bindless::Kind::storage, make(whole, mip, 0, info_.layers)));
    }
  }
}

void Image::release() noexcept {
  if (!image_) return;
  device_->note_allocation(-static_cast<int64_t>(bytes_));
  device_->defer([device = device_, image = image_, allocation = allocation_, view = view_, part_views = std::move(part_views_),
                  sampled = sampled_, storages = std::move(storages_),
                  sampled_kind = info_.material ? Bindless::Kind::material : Bindless::Kind::frame] {
    if (sampled != k_no_index) device->bindless().remove(sampled_kind, sampled);
    for (const uint32_t storage : storages) device->bindless().remove(Bindless::Kind::storage, storage);
    for (const VkImageView part : part_views) vkDestroyImageView(device->handle(), part, nullptr);
    vkDestroyImageView(device->handle(), view, nullptr);
    vmaDestroyImage(device->allocator(), image, allocation);
  });
  image_ = VK_NULL_HANDLE;
}

void Image::swap(Image& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(info_, other.info_);
  std::swap(image_, other.image_);
  std::swap(allocation_, other.allocation_);
  std::swap(bytes_, other.bytes_);
  std::swap(view_, other.view_);
  std::swap(layer_views_, other.layer_views_);
  std::swap(sampled_, other.sampled_);
  std::swap(attachment_view_, other.attachment_view_);
  std::swap(part_views_, other.part_views_);
  std::swap(storages_, other.storages_);
  std::swap(state_, other.state_);
}

}  // namespace gnomon
