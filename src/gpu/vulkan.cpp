// Result names and the one place where a failed call becomes an Error.
#include "gpu/vulkan.h"

#include "gpu/device_errors.h"

namespace gnomon {

std::string_view vk_result_name(VkResult result) {
  switch (result) {
    case VK_SUCCESS:
      return "VK_SUCCESS";
    case VK_NOT_READY:
      return "VK_NOT_READY";
    case VK_TIMEOUT:
      return "VK_TIMEOUT";
    case VK_INCOMPLETE:
      return "VK_INCOMPLETE";
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
      return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "VK_ERROR_MEMORY_MAP_FAILED";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "VK_ERROR_TOO_MANY_OBJECTS";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
      return "VK_ERROR_FORMAT_NOT_SUPPORTED";
    case VK_ERROR_FRAGMENTED_POOL:
      return "VK_ERROR_FRAGMENTED_POOL";
    default:
      return "an unlisted result";
  }
}

void vk_check(VkResult result, std::string_view call) {
  if (result == VK_SUCCESS) return;
  const std::string_view name = vk_result_name(result);
  switch (result) {
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      fail("{}: {}: the GPU's memory is used up; smaller maps or pictures need less", call, name);
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      fail("{}: {}: the machine's memory is used up", call, name);
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      fail_device("{}: {}: no Vulkan driver is installed that gnomon can use", call, name);
    case VK_ERROR_FEATURE_NOT_PRESENT:
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      fail_device("{}: {}: see 'gnomon doctor'", call, name);
    case VK_ERROR_DEVICE_LOST:
      throw DeviceLost(fmt::format("{}: the GPU was lost (hung, reset or removed)", call));
    default:
      fail("{}: {} ({})", call, name, static_cast<int>(result));
  }
}

}  // namespace gnomon
