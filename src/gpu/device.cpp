// Device choice, creation, submission.
#include "gpu/device.h"

#include <vk_mem_alloc.h>

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "base/log.h"
#include "base/lower_case.h"
#include "gpu/device_errors.h"
#include "gpu/device_info.h"

namespace gnomon {
namespace {

int preference(const DeviceInfo& info) {
  static constexpr std::string_view k_order[] = {"discrete", "virtual", "integrated", "other", "cpu"};
  return static_cast<int>(std::find(std::begin(k_order), std::end(k_order), info.type) - std::begin(k_order));
}

std::string describe(const std::vector<DeviceInfo>& infos) {
  std::string text;
  for (size_t i = 0; i < infos.size(); ++i) {
    text += fmt::format("\n  {}: {} ({})", i, infos[i].name, infos[i].type);
    if (!infos[i].missing.empty()) text += fmt::format(", lacks {}", fmt::join(infos[i].missing, ", "));
  }
  return text;
}

// The index of the device to use.
size_t choose(const std::vector<DeviceInfo>& infos, const std::string& choice) {
  if (infos.empty())
    fail_device("no Vulkan device is present; on a machine without a GPU install a CPU driver (Debian: mesa-vulkan-drivers)");
  std::vector<size_t> fitting;
  for (size_t i = 0; i < infos.size(); ++i) {
    size_t number = 0;
    const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), number);
    const bool is_number = !choice.empty() && error == std::errc() && end == choice.data() + choice.size();
    const bool named =
        choice.empty() || (is_number ? number == i : lower_case(infos[i].name).find(lower_case(choice)) != std::string::npos);
    if (named && infos[i].missing.empty()) fitting.push_back(i);
  }
  if (fitting.empty()) {
    fail_device("no usable Vulkan device{}; there are:{}", choice.empty() ? "" : fmt::format(" matches '{}'", choice),
                describe(infos));
  }
  return *std::min_element(fitting.begin(), fitting.end(),
                           [&](size_t a, size_t b) { return preference(infos[a]) < preference(infos[b]); });
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  const Instance instance(false);
  std::vector<DeviceInfo> infos;
  for (const VkPhysicalDevice physical : instance.physical_devices()) infos.push_back(device_info(physical));
  return infos;
}

Device::Device(const DeviceOptions& options)
    : instance_(options.validate || validation_wanted(), options.window.instance_extensions) {
  const auto physical = instance_.physical_devices();
  std::vector<DeviceInfo> infos;
  const bool with_window = options.window.can_present != nullptr;
  for (const VkPhysicalDevice candidate : physical) {
    infos.push_back(device_info(candidate));
    // A device with missing features may lack the queue family, too.
    if (!with_window || !infos.back().missing.empty()) continue;
    const bool presents = options.window.can_present(instance_.handle(), candidate, find_queue_family(candidate));
    if (!has_device_extension(candidate, VK_KHR_SWAPCHAIN_EXTENSION_NAME) || !presents)
      infos.back().missing.emplace_back("pictures in a window");
  }
  const size_t index = choose(infos, options.choice);
  physical_ = physical[index];
  info_ = infos[index];
  create_device(with_window);
}

void Device::create_device(bool with_window) {
  FeatureChain chain(info_);
  if (with_window) chain.extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  queue_family_ = find_queue_family(physical_);
  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &chain.features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<uint32_t>(chain.extensions.size());
  info.ppEnabledExtensionNames = chain.extensions.data();
  vk_check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);

  VmaAllocatorCreateInfo allocator = {};
  allocator.flags = VMA_ALLOCATOR_CREATE_BUFFER_DEVICE_ADDRESS_BIT;
  allocator.physicalDevice = physical_;
  allocator.device = device_;
  allocator.instance = instance_.handle();
  allocator.vulkanApiVersion = VK_API_VERSION_1_3;
  vk_check(vmaCreateAllocator(&allocator, &allocator_), "vmaCreateAllocator");

  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(vkGetDeviceProcAddr(device_, name));
  };
  load(set_name_, "vkSetDebugUtilsObjectNameEXT");
  load(begin_label_, "vkCmdBeginDebugUtilsLabelEXT");
  load(end_label_, "vkCmdEndDebugUtilsLabelEXT");
  VkShaderStageFlags stages = VK_SHADER_STAGE_ALL;
  if (info_.ray_tracing) {
    load(ray_tracing_.create_acceleration_structure, "vkCreateAccelerationStructureKHR");
    load(ray_tracing_.destroy_acceleration_structure, "vkDestroyAccelerationStructureKHR");
    load(ray_tracing_.build_sizes, "vkGetAccelerationStructureBuildSizesKHR");
    load(ray_tracing_.address, "vkGetAccelerationStructureDeviceAddressKHR");
    load(ray_tracing_.cmd_build, "vkCmdBuildAccelerationStructuresKHR");
    load(ray_tracing_.create_pipelines, "vkCreateRayTracingPipelinesKHR");
    load(ray_tracing_.group_handles, "vkGetRayTracingShaderGroupHandlesKHR");
    load(ray_tracing_.cmd_trace, "vkCmdTraceRaysKHR");
  }
  bindless_ = std::make_unique<Bindless>(device_, info_.anisotropy ? std::min(16.0f, info_.max_anisotropy) : 1.0f, stages);
  pipelines_ = std::make_unique<PipelinePool>(device_);

  VkSemaphoreTypeCreateInfo type = {VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  const VkSemaphoreCreateInfo semaphore = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type};
  vk_check(vkCreateSemaphore(device_, &semaphore, nullptr, &timeline_), "vkCreateSemaphore");
}

Device::~Device() {
  vkDeviceWaitIdle(device_);
  deferred_.release_held(submitted_);
  deferred_.run_up_to(submitted_);
  vkDestroySemaphore(device_, timeline_, nullptr);
  pipelines_.reset();
  bindless_.reset();
  vmaDestroyAllocator(allocator_);
  vkDestroyDevice(device_, nullptr);
}

void Device::check_device(VkResult result, const char* call) {
  if (result == VK_ERROR_DEVICE_LOST) {
    throw DeviceLost(
        fmt::format("{}: the GPU was lost (hung, reset or removed); the last recorded pass was '{}'", call, last_pass_));
  }
  vk_check(result, call);
}

uint64_t Device::submit(VkCommandBuffer commands, VkSemaphore acquired, VkSemaphore finished) {
  VkCommandBufferSubmitInfo buffer = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands;
  VkSemaphoreSubmitInfo wait = {VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  wait.semaphore = acquired;
  wait.stageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
  VkSemaphoreSubmitInfo signals[2] = {{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO}, {VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO}};
  signals[0].semaphore = timeline_;
  signals[0].value = ++submitted_;
  signals[1].semaphore = finished;
  for (auto& signal : signals) signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkSubmitInfo2 info = {VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &buffer;
  info.waitSemaphoreInfoCount = acquired ? 1 : 0;
  info.pWaitSemaphoreInfos = &wait;
  info.signalSemaphoreInfoCount = finished ? 2 : 1;
  info.pSignalSemaphoreInfos = signals;
  check_device(vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
  return submitted_;
}

void Device::wait(uint64_t value) {
  VkSemaphoreWaitInfo info = {VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
  info.semaphoreCount = 1;
  info.pSemaphores = &timeline_;
  info.pValues = &value;
  check_device(vkWaitSemaphores(device_, &info, UINT64_MAX), "vkWaitSemaphores");
  collect();
}

void Device::wait_idle() {
  check_device(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle");
  collect();
}

void Device::end_recording() {
  GNOMON_ASSERT(recordings_ > 0);
  if (--recordings_ > 0) return;
  deferred_.release_held(submitted_);
}

void Device::collect() {
  uint64_t finished = 0;
  check_device(vkGetSemaphoreCounterValue(device_, timeline_, &finished), "vkGetSemaphoreCounterValue");
  deferred_.run_up_to(finished);
}

void Device::check_validation() {
  const auto messages = instance_.log().take();
  if (messages.empty()) return;
  throw ValidationError(fmt::format("validation ({} messages):\n{}", messages.size(), fmt::join(messages, "\n")));
}

void Device::set_name(VkObjectType type, uint64_t handle, const std::string& name) const {
  if (!set_name_) return;
  VkDebugUtilsObjectNameInfoEXT info = {VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  set_name_(device_, &info);
}

void Device::begin_label(VkCommandBuffer commands, const std::string& name) const {
  if (!begin_label_) return;
  VkDebugUtilsLabelEXT label = {VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = name.c_str();
  begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
  if (end_label_) end_label_(commands);
}

}  // namespace gnomon
