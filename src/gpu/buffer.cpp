// Buffers from VMA.
#include "gpu/buffer.h"

#include <vk_mem_alloc.h>

#include "base/error.h"

namespace gnomon {

Buffer::Buffer(Device& device, std::string name, size_t bytes, BufferMemory memory, VkBufferUsageFlags extra_usage)
    : device_(&device), name_(std::move(name)), bytes_(bytes), state_(std::make_shared<ResourceState>()) {
  GNOMON_ASSERT(bytes > 0);
  VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
               VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT | extra_usage;
  VmaAllocationCreateInfo allocation = {};
  allocation.usage = VMA_MEMORY_USAGE_AUTO;
  if (memory == BufferMemory::upload) {
    allocation.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT | VMA_ALLOCATION_CREATE_MAPPED_BIT;
  } else if (memory == BufferMemory::readback) {
    allocation.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT | VMA_ALLOCATION_CREATE_MAPPED_BIT;
  }
  VmaAllocationInfo result = {};
  device.reserve_defer();
  const VkResult created = vmaCreateBuffer(device.allocator(), &info, &allocation, &buffer_, &allocation_, &result);
  if (created != VK_SUCCESS) {
    buffer_ = VK_NULL_HANDLE;
    vk_check(created, fmt::format("buffer '{}' of {:.1f} MiB", name_, static_cast<double>(bytes) / 1048576.0));
  }
  // Mesa's CPU driver maps memory that it could not get as success, at address 0 (address space of 900 MB; Mesa 25).
  const bool unmapped = memory != BufferMemory::device && reinterpret_cast<uintptr_t>(result.pMappedData) <= result.offset;
  mapped_ = unmapped ? nullptr : static_cast<std::byte*>(result.pMappedData);
  device.note_allocation(static_cast<int64_t>(bytes));
  device.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(buffer_), name_);
  VkBufferDeviceAddressInfo address = {VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
  address.buffer = buffer_;
  address_ = vkGetBufferDeviceAddress(device.handle(), &address);
  if (unmapped) {
    release();
    vk_check(VK_ERROR_MEMORY_MAP_FAILED,
             fmt::format("buffer '{}' of {:.1f} MiB", name_, static_cast<double>(bytes) / 1048576.0));
  }
}

void Buffer::invalidate() const {
  vk_check(vmaInvalidateAllocation(device_->allocator(), allocation_, 0, VK_WHOLE_SIZE), "vmaInvalidateAllocation");
}

void Buffer::flush() const {
  vk_check(vmaFlushAllocation(device_->allocator(), allocation_, 0, VK_WHOLE_SIZE), "vmaFlushAllocation");
}

void Buffer::release() noexcept {
  if (!buffer_) return;
  device_->note_allocation(-static_cast<int64_t>(bytes_));
  device_->defer([allocator = device_->allocator(), buffer = buffer_, allocation = allocation_] {
    vmaDestroyBuffer(allocator, buffer, allocation);
  });
  buffer_ = VK_NULL_HANDLE;
}

void Buffer::swap(Buffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(name_, other.name_);
  std::swap(buffer_, other.buffer_);
  std::swap(allocation_, other.allocation_);
  std::swap(address_, other.address_);
  std::swap(bytes_, other.bytes_);
  std::swap(mapped_, other.mapped_);
  std::swap(state_, other.state_);
}

}  // namespace gnomon
