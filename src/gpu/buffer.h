// A buffer with a device address: move-only, named at creation, destroyed when the GPU has finished with it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "gpu/device.h"
#include "gpu/use.h"

struct VmaAllocation_T;

namespace gnomon {

enum class BufferMemory {
  device,    // GPU only
  upload,    // written by the CPU, read by the GPU
  readback,  // written by the GPU, read by the CPU
};

class Buffer {
 public:
  Buffer() = default;
  // bytes > 0. `extra_usage` adds to storage, transfer, indirect and device-address use.
  Buffer(Device& device, std::string name, size_t bytes, BufferMemory memory = BufferMemory::device,
         VkBufferUsageFlags extra_usage = 0);
  ~Buffer() { release(); }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    if (this != &other) release(), swap(other);
    return *this;
  }

  explicit operator bool() const { return buffer_ != VK_NULL_HANDLE; }
  VkBuffer handle() const { return buffer_; }
  VkDeviceAddress address() const { return address_; }
  size_t bytes() const { return bytes_; }
  const std::string& name() const { return name_; }
  ResourceState& state() const { return *state_; }
  // For a recorder, which takes the state back where what it recorded is never submitted; the resource may be gone by then.
  const std::shared_ptr<ResourceState>& shared_state() const { return state_; }

  // CPU view of upload and readback buffers; a readback view is valid after the GPU's writes were waited for.
  std::byte* mapped() const { return mapped_; }
  template <class T>
  std::span<T> mapped_as() const {
    return {reinterpret_cast<T*>(mapped_), bytes_ / sizeof(T)};
  }
  void invalidate() const;  // before the CPU reads
  void flush() const;       // after the CPU wrote

 private:
  void release() noexcept;
  void swap(Buffer& other) noexcept;

  Device* device_ = nullptr;
  std::string name_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VmaAllocation_T* allocation_ = nullptr;
  VkDeviceAddress address_ = 0;
  size_t bytes_ = 0;
  std::byte* mapped_ = nullptr;
  std::shared_ptr<ResourceState> state_;
};

}  // namespace gnomon
