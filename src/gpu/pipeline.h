// Compute, graphics and ray-tracing pipelines from a default description.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device.h"

namespace gnomon {

// Values of specialization constants 0, 1, 2, ... of a shader.
using SpecialisationConstants = std::vector<uint32_t>;

class Pipeline {
 public:
  Pipeline() = default;
  Pipeline(Device& device, VkPipeline pipeline, VkPipelineBindPoint bind_point, PipelineRecipe recipe)
      : device_(&device), pipeline_(pipeline), bind_point_(bind_point), recipe_(std::move(recipe)) {}
  ~Pipeline() { release(); }
  Pipeline(Pipeline&& other) noexcept { swap(other); }
  Pipeline& operator=(Pipeline&& other) noexcept {
    if (this != &other) release(), swap(other);
    return *this;
  }

  explicit operator bool() const { return pipeline_ != VK_NULL_HANDLE; }
  VkPipeline handle() const { return pipeline_; }
  VkPipelineBindPoint bind_point() const { return bind_point_; }

 private:
  void release() noexcept;
  void swap(Pipeline& other) noexcept;

  Device* device_ = nullptr;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkPipelineBindPoint bind_point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
  PipelineRecipe recipe_;
};

Pipeline make_compute_pipeline(Device& device, std::string_view shader, const SpecialisationConstants& constants = {});

// Triangles without vertex input (shaders pull by address); viewport, scissor, cull mode are set while recording.
struct GraphicsPipelineInfo {
  std::string vertex, geometry, fragment;  // shader names; an empty fragment shader makes a depth-only pipeline
  std::vector<VkFormat> colour_formats;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  VkCompareOp depth_compare = VK_COMPARE_OP_GREATER;  // reversed Z of the viewer's camera
  bool depth_clamp = false;                           // ignored where the device has none
  uint32_t samples = 1;
  uint32_t view_mask = 0;  // layers that multiview repeats each draw in
  SpecialisationConstants constants;
};
Pipeline make_graphics_pipeline(Device& device, const GraphicsPipelineInfo& info);

// One ray-generation, one miss and one any-hit shader (visibility rays need no closest-hit).
class RayPipeline {
 public:
  RayPipeline() = default;
  // Throws Error (device) where the device cannot trace rays.
  RayPipeline(Device& device, std::string_view raygen, std::string_view miss, std::string_view any_hit,
              const SpecialisationConstants& constants = {});
  const Pipeline& pipeline() const { return pipeline_; }
  void trace(VkCommandBuffer commands, uint32_t width, uint32_t height) const;

 private:
  Device* device_ = nullptr;
  Pipeline pipeline_;
  Buffer table_;
  VkStridedDeviceAddressRegionKHR raygen_ = {}, miss_ = {}, hit_ = {}, callable_ = {};
};

}  // namespace gnomon
