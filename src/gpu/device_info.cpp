// Queries of a physical device.
#include "gpu/device_info.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"

namespace gnomon {
namespace {

std::vector<std::string> device_extensions(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vk_check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr), "vkEnumerateDeviceExtensionProperties");
  std::vector<VkExtensionProperties> properties(count);
  vk_check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, properties.data()),
           "vkEnumerateDeviceExtensionProperties");
  std::vector<std::string> names;
  for (const auto& property : properties) names.emplace_back(property.extensionName);
  return names;
}

std::string type_name(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "cpu";
    default:
      return "other";
  }
}

struct Required {
  bool present;
  const char* name;
};

// Everything that Vulkan 1.3 lets a device leave out and that every frame of gnomon uses.
void find_missing(const VkPhysicalDeviceFeatures& core, const VkPhysicalDeviceVulkan11Features& v11,
                  const VkPhysicalDeviceVulkan12Features& v12, const VkPhysicalDeviceVulkan13Features& v13, DeviceInfo& info) {
  if (info.api_version < VK_API_VERSION_1_3) {
    info.missing.push_back("Vulkan 1.3");
    return;
  }
  const Required required[] = {
      {core.multiDrawIndirect == VK_TRUE, "multiDrawIndirect"},
      {core.drawIndirectFirstInstance == VK_TRUE, "drawIndirectFirstInstance"},
      {core.geometryShader == VK_TRUE, "geometryShader (for gl_PrimitiveID)"},
      {core.shaderInt64 == VK_TRUE, "shaderInt64"},
      {core.shaderStorageImageReadWithoutFormat == VK_TRUE, "shaderStorageImageReadWithoutFormat"},
      {core.shaderStorageImageWriteWithoutFormat == VK_TRUE, "shaderStorageImageWriteWithoutFormat"},
      {core.shaderStorageImageExtendedFormats == VK_TRUE, "shaderStorageImageExtendedFormats"},
      {v11.shaderDrawParameters == VK_TRUE, "shaderDrawParameters"},
      {v12.drawIndirectCount == VK_TRUE, "drawIndirectCount"},
      {v12.bufferDeviceAddress == VK_TRUE, "bufferDeviceAddress"},
      {v12.scalarBlockLayout == VK_TRUE, "scalarBlockLayout"},
      {v12.timelineSemaphore == VK_TRUE, "timelineSemaphore"},
      {v12.runtimeDescriptorArray == VK_TRUE, "runtimeDescriptorArray"},
      {v12.descriptorBindingPartiallyBound == VK_TRUE, "descriptorBindingPartiallyBound"},
      {v12.descriptorBindingSampledImageUpdateAfterBind == VK_TRUE, "descriptorBindingSampledImageUpdateAfterBind"},
      {v12.descriptorBindingStorageImageUpdateAfterBind == VK_TRUE, "descriptorBindingStorageImageUpdateAfterBind"},
      {v12.shaderSampledImageArrayNonUniformIndexing == VK_TRUE, "shaderSampledImageArrayNonUniformIndexing"},
      {v13.dynamicRendering == VK_TRUE, "dynamicRendering"},
      {v13.synchronization2 == VK_TRUE, "synchronization2"},
      {v13.maintenance4 == VK_TRUE, "maintenance4"},
  };
  for (const auto& feature : required) {
    if (!feature.present) info.missing.emplace_back(feature.name);
  }
}

std::vector<int> surface_sample_counts(const VkPhysicalDeviceLimits& limits) {
  // Colour and depth attachments, read back in compute. Standard sample positions let depth be turned into positions.
  const VkSampleCountFlags counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts &
                                    limits.sampledImageColorSampleCounts & limits.sampledImageDepthSampleCounts;
  std::vector<int> supported = {1};
  for (const int samples : {2, 4, 8}) {
    if ((counts & static_cast<VkSampleCountFlags>(samples)) && limits.standardSampleLocations) supported.push_back(samples);
  }
  return supported;
}

std::vector<VkQueueFamilyProperties> queue_families(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  return families;
}

bool serves_all(const VkQueueFamilyProperties& family) {
  constexpr VkQueueFlags k_needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  return (family.queueFlags & k_needed) == k_needed;
}

}  // namespace

bool has_device_extension(VkPhysicalDevice physical, std::string_view name) {
  const auto extensions = device_extensions(physical);
  return std::find(extensions.begin(), extensions.end(), name) != extensions.end();
}

uint32_t find_queue_family(VkPhysicalDevice physical) {
  const auto families = queue_families(physical);
  const auto found = std::find_if(families.begin(), families.end(), serves_all);
  if (found == families.end()) fail_device("the device has no queue for both graphics and compute");
  return static_cast<uint32_t>(found - families.begin());
}

uint64_t timestamp_mask(VkPhysicalDevice physical) {
  const auto families = queue_families(physical);
  const auto found = std::find_if(families.begin(), families.end(), serves_all);
  const uint32_t bits = found == families.end() ? 0 : found->timestampValidBits;
  return bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
}

DeviceInfo device_info(VkPhysicalDevice physical) {
  DeviceInfo info;
  const auto extensions = device_extensions(physical);
  const auto has = [&](const char* name) {
    for (const auto& extension : extensions) {
      if (extension == name) return true;
    }
    return false;
  };

  VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  VkPhysicalDeviceDriverProperties driver = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceRayTracingPipelinePropertiesKHR ray = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR};
  VkPhysicalDeviceAccelerationStructurePropertiesKHR acceleration = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  VkPhysicalDeviceFeatures2 features = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan11Features v11 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR as_features = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  VkPhysicalDeviceRayTracingPipelineFeaturesKHR rt_features = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR};

  VkPhysicalDeviceProperties basic;
  vkGetPhysicalDeviceProperties(physical, &basic);
  const bool ray_extensions = has(VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME) &&
                              has(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME) &&
                              has(VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME);
  properties.pNext = &driver;
  if (ray_extensions) {
    driver.pNext = &ray;
    ray.pNext = &acceleration;
    v13.pNext = &as_features;
    as_features.pNext = &rt_features;
  }
  if (basic.apiVersion >= VK_API_VERSION_1_3) {
    features.pNext = &v11;
    v11.pNext = &v12;
    v12.pNext = &v13;
  }
  vkGetPhysicalDeviceProperties2(physical, &properties);
  vkGetPhysicalDeviceFeatures2(physical, &features);

  info.name = basic.deviceName;
  info.type = type_name(basic.deviceType);
  info.software = basic.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.api_version = basic.apiVersion;
  info.driver = driver.driverName;
  info.driver_version = driver.driverInfo[0] ? driver.driverInfo : fmt::format("{:#x}", basic.driverVersion);
  info.ray_tracing = ray_extensions && as_features.accelerationStructure && rt_features.rayTracingPipeline;
  info.ray_query = has(VK_KHR_RAY_QUERY_EXTENSION_NAME);
  info.anisotropy = features.features.samplerAnisotropy;
  info.depth_clamp = features.features.depthClamp;
  info.pipeline_statistics = features.features.pipelineStatisticsQuery;
  info.vertex_layer = v12.shaderOutputLayer;
  info.multiview = v11.multiview;
  info.geometry_shader = features.features.geometryShader;
  info.mesh_shader = has("VK_EXT_mesh_shader");
  info.max_anisotropy = basic.limits.maxSamplerAnisotropy;
  info.timestamp_ms = timestamp_mask(physical) != 0 ? basic.limits.timestampPeriod * 1e-6 : 0.0;
  info.sample_counts = surface_sample_counts(basic.limits);
  info.shader_group_handle_size = ray.shaderGroupHandleSize;
  info.shader_group_base_alignment = ray.shaderGroupBaseAlignment;
  info.shader_group_handle_alignment = ray.shaderGroupHandleAlignment;
  info.scratch_alignment = acceleration.minAccelerationStructureScratchOffsetAlignment;

  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);
  for (uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
      info.memory_bytes = std::max<uint64_t>(info.memory_bytes, memory.memoryHeaps[i].size);
    }
  }
  find_missing(features.features, v11, v12, v13, info);
  return info;
}

FeatureChain::FeatureChain(const DeviceInfo& info) {
  auto& core = features.features;
  core.multiDrawIndirect = core.drawIndirectFirstInstance = core.shaderInt64 = VK_TRUE;
  core.shaderStorageImageReadWithoutFormat = core.shaderStorageImageWriteWithoutFormat =
      core.shaderStorageImageExtendedFormats = VK_TRUE;
  core.geometryShader = VK_TRUE;
  core.samplerAnisotropy = info.anisotropy;
  core.depthClamp = info.depth_clamp;
  core.pipelineStatisticsQuery = info.pipeline_statistics;
  v11.shaderDrawParameters = VK_TRUE;
  v11.multiview = info.multiview;
  v12.drawIndirectCount = v12.bufferDeviceAddress = v12.scalarBlockLayout = v12.timelineSemaphore = VK_TRUE;
  v12.descriptorIndexing = v12.runtimeDescriptorArray = v12.descriptorBindingPartiallyBound = VK_TRUE;
  v12.descriptorBindingSampledImageUpdateAfterBind = v12.descriptorBindingStorageImageUpdateAfterBind = VK_TRUE;
  v12.shaderSampledImageArrayNonUniformIndexing = VK_TRUE;
  v12.shaderOutputLayer = info.vertex_layer;
  v13.dynamicRendering = v13.synchronization2 = v13.maintenance4 = VK_TRUE;
  features.pNext = &v11;
  v11.pNext = &v12;
  v12.pNext = &v13;
  if (info.ray_tracing) {
    acceleration.accelerationStructure = ray_pipeline.rayTracingPipeline = VK_TRUE;
    v13.pNext = &acceleration;
    acceleration.pNext = &ray_pipeline;
    extensions = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME,
                  VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
  }
}

}  // namespace gnomon
