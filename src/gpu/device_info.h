// What a physical device can do, and which features gnomon switches on.
#pragma once

#include "gpu/device.h"

namespace gnomon {

DeviceInfo device_info(VkPhysicalDevice physical);
bool has_device_extension(VkPhysicalDevice physical, std::string_view name);

// The feature chain for vkCreateDevice: required features, and the optional ones that `info` reports.
struct FeatureChain {
  explicit FeatureChain(const DeviceInfo& info);
  FeatureChain(const FeatureChain&) = delete;
  FeatureChain& operator=(const FeatureChain&) = delete;

  VkPhysicalDeviceFeatures2 features = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan11Features v11 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR acceleration = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  VkPhysicalDeviceRayTracingPipelineFeaturesKHR ray_pipeline = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR};
  std::vector<const char*> extensions;
};

// The queue family for graphics and compute; throws Error (device) when there is none.
uint32_t find_queue_family(VkPhysicalDevice physical);
// The bits of that family's timestamps that count; 0: it has none.
uint64_t timestamp_mask(VkPhysicalDevice physical);

}  // namespace gnomon
