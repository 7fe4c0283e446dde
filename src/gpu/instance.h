// The Vulkan instance, validation, and the choice of a physical device.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace gnomon {

// What validation said. Any message is an error: Device::check_validation throws it.
class ValidationLog {
 public:
  void add(std::string message);
  std::vector<std::string> take();

 private:
  std::mutex mutex_;
  std::vector<std::string> messages_;
};

class Instance {
 public:
  // validate: core and synchronization validation; `extensions`: those of a window. Throws Error (device) when there is no
  // Vulkan, or no validation layer.
  explicit Instance(bool validate, std::vector<const char*> extensions = {});
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle() const { return instance_; }
  bool validates() const { return messenger_ != VK_NULL_HANDLE; }
  ValidationLog& log() const { return log_; }
  std::vector<VkPhysicalDevice> physical_devices() const;

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  mutable ValidationLog log_;
};

// True in debug builds and where the environment says GNOMON_VALIDATE=1.
bool validation_wanted();

}  // namespace gnomon
