// The two descriptor sets that every pipeline has: what a scene brings (material textures, samplers) and what a frame makes
// (maps, attachments, storage images), each by index. Buffers go by device address. Two sets, because synchronization
// validation takes every descriptor of an array for used: draws that read materials would else "read" the image they are
// drawing to.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gpu/glsl/samplers.glsl"
#include "gpu/vulkan.h"

namespace gnomon {

class Bindless {
 public:
  static constexpr uint32_t k_max_images = 8192;
  static constexpr uint32_t k_max_samplers = 64;
  static constexpr uint32_t k_max_storage_images = 1024;
  static constexpr uint32_t k_push_constant_bytes = 128;  // what every Vulkan device has

  Bindless(VkDevice device, float max_anisotropy, VkShaderStageFlags stages);
  ~Bindless();
  Bindless(const Bindless&) = delete;
  Bindless& operator=(const Bindless&) = delete;

  VkPipelineLayout pipeline_layout() const { return pipeline_layout_; }
  const std::array<VkDescriptorSet, 2>& sets() const { return sets_; }

  enum class Kind : uint32_t { material, frame, storage };
  uint32_t add(Kind kind, VkImageView view);
  void remove(Kind kind, uint32_t index) noexcept { slots_[static_cast<size_t>(kind)].free.push_back(index); }

 private:
  struct Slots {
    std::vector<uint32_t> free;
    uint32_t next = 0;
  };
  void create_layouts(VkShaderStageFlags stages);
  void create_samplers(float max_anisotropy);

  VkDevice device_;
  std::array<VkDescriptorSetLayout, 2> set_layouts_ = {};
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::array<VkDescriptorSet, 2> sets_ = {};
  VkPipelineLayout pipeline_layout_ = VK_NULL_HANDLE;
  std::vector<VkSampler> samplers_;
  std::array<Slots, 3> slots_;  // by Kind
};

}  // namespace gnomon
