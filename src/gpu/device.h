// The logical device and what belongs to it: queue, memory, bindless set, deferred destruction.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gpu/bindless.h"
#include "gpu/deferred.h"
#include "gpu/instance.h"
#include "gpu/pipeline_pool.h"
#include "gpu/vulkan.h"

struct VmaAllocator_T;

namespace gnomon {

// What `gnomon doctor` shows and what techniques ask for.
struct DeviceInfo {
  std::string name, driver, driver_version, type;  // type: "discrete", "integrated", "virtual", "cpu", "other"
  uint32_t api_version = 0;
  bool software = false;     // timestamps may lie: passes are submitted alone and timed by the wall clock
  bool ray_tracing = false;  // ray-tracing pipeline and acceleration structures
  bool ray_query = false;    // reported only
  bool anisotropy = false;
  bool depth_clamp = false;
  bool pipeline_statistics = false;
  bool vertex_layer = false;  // gl_Layer from the vertex shader
  bool multiview = false, geometry_shader = false, mesh_shader = false;
  float max_anisotropy = 1.0f;
  double timestamp_ms = 0.0;       // per tick; 0: the queue has no timestamps
  uint64_t memory_bytes = 0;       // largest device-local heap
  std::vector<int> sample_counts;  // that the surface buffer can use
  uint32_t shader_group_handle_size = 0, shader_group_base_alignment = 0, shader_group_handle_alignment = 0;
  uint32_t scratch_alignment = 0;
  std::vector<std::string> missing;  // required features that the device lacks: it is then unusable
};

// Entry points of the ray-tracing extensions; null where the device has none.
struct RayTracingFunctions {
  PFN_vkCreateAccelerationStructureKHR create_acceleration_structure = nullptr;
  PFN_vkDestroyAccelerationStructureKHR destroy_acceleration_structure = nullptr;
  PFN_vkGetAccelerationStructureBuildSizesKHR build_sizes = nullptr;
  PFN_vkGetAccelerationStructureDeviceAddressKHR address = nullptr;
  PFN_vkCmdBuildAccelerationStructuresKHR cmd_build = nullptr;
  PFN_vkCreateRayTracingPipelinesKHR create_pipelines = nullptr;
  PFN_vkGetRayTracingShaderGroupHandlesKHR group_handles = nullptr;
  PFN_vkCmdTraceRaysKHR cmd_trace = nullptr;
};

// What a program with a window needs beyond the rest; the default needs nothing.
struct WindowNeeds {
  std::vector<const char*> instance_extensions;
  // Whether a queue family can show pictures in the window; empty: there is no window.
  std::function<bool(VkInstance, VkPhysicalDevice, uint32_t family)> can_present;
};

struct DeviceOptions {
  std::string choice;  // part of the device's name, or its number in `gnomon list devices`; empty: a hardware GPU first
  bool validate = false;
  WindowNeeds window = {};
};

class Device {
 public:
  // Throws Error (device) when no device fits, naming those there are and what each lacks.
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice handle() const { return device_; }
  VkInstance instance() const { return instance_.handle(); }
  bool validates() const { return instance_.validates(); }
  VkPhysicalDevice physical() const { return physical_; }
  VkQueue queue() const { return queue_; }
  uint32_t queue_family() const { return queue_family_; }
  VmaAllocator_T* allocator() const { return allocator_; }
  const DeviceInfo& info() const { return info_; }
  const RayTracingFunctions& ray_tracing() const { return ray_tracing_; }
  Bindless& bindless() { return *bindless_; }
  VkPipelineLayout pipeline_layout() const { return bindless_->pipeline_layout(); }
  PipelinePool& pipelines() { return *pipelines_; }

  // Begins and ends the one-queue timeline: submit returns the value that `wait` waits for. The semaphores are those of a
  // window, which knows no timeline: what the commands copy waits for `acquired`; `finished` is for the presentation.
  uint64_t submit(VkCommandBuffer commands, VkSemaphore acquired = VK_NULL_HANDLE, VkSemaphore finished = VK_NULL_HANDLE);
  void wait(uint64_t value);

  void wait_idle();

  // Between the two a command buffer is being recorded, which may use what is destroyed meanwhile. They nest.
  // What is finished goes first: validation takes every image of the bindless set for used by what is recorded.
  void begin_recording() {
    if (recordings_++ == 0) collect();
  }
  void end_recording();

  // Who will call `defer` once reserves it while there is memory: letting go must not fail.
  void reserve_defer() { deferred_.reserve(); }
  // Runs `destroy` once the GPU has finished everything submitted so far, and what is being recorded now.
  template <class Call>
  void defer(Call&& destroy) noexcept {
    deferred_.add(submitted_, recordings_ > 0, std::forward<Call>(destroy));
  }

  // Throws Error with what validation has said since the last call. No-op without validation.
  void check_validation();

  // For the message of a lost device.
  void set_last_pass(const std::string& name) { last_pass_ = name; }

  void set_name(VkObjectType type, uint64_t handle, const std::string& name) const;
  void begin_label(VkCommandBuffer commands, const std::string& name) const;
  void end_label(VkCommandBuffer commands) const;

  // Bytes of all live buffers and images: a technique's memory is the difference that building it makes.
  uint64_t allocated_bytes() const { return allocated_bytes_; }
  void note_allocation(int64_t bytes) {
    allocated_bytes_ = static_cast<uint64_t>(static_cast<int64_t>(allocated_bytes_) + bytes);
  }

 private:
  void create_device(bool with_window);
  void collect();
  void check_device(VkResult result, const char* call);

  Instance instance_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  VmaAllocator_T* allocator_ = nullptr;
  DeviceInfo info_;
  RayTracingFunctions ray_tracing_;
  std::unique_ptr<Bindless> bindless_;
  std::unique_ptr<PipelinePool> pipelines_;
  VkSemaphore timeline_ = VK_NULL_HANDLE;
  uint64_t submitted_ = 0;
  DeferredDestruction deferred_;  // `held`: until the open recordings are submitted
  int recordings_ = 0;
  std::string last_pass_ = "none";
  uint64_t allocated_bytes_ = 0;
  PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

// Every Vulkan device of the machine, in the order that `--device NUMBER` counts.
std::vector<DeviceInfo> list_devices();

}  // namespace gnomon
