// The one descriptor set: sampled images, samplers and storage images by index. Buffers go by device address.
#pragma once

#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace gnomon {

// Samplers that every shader can name; the order is that of glsl/bindless.glsl.
enum class SamplerKind : uint32_t { nearest_clamp, linear_clamp, depth_compare_linear, depth_compare_nearest, material_first };

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
  VkDescriptorSet set() const { return set_; }

  uint32_t add_sampled(VkImageView view);
  uint32_t add_storage(VkImageView view);
  void remove_sampled(uint32_t index) { free_sampled_.push_back(index); }
  void remove_storage(uint32_t index) { free_storage_.push_back(index); }

  // The anisotropic, mipmapped sampler of material textures with the given wrap modes (0 repeat, 1 clamp, 2 mirror).
  static uint32_t material_sampler(uint32_t wrap_u, uint32_t wrap_v) {
    return static_cast<uint32_t>(SamplerKind::material_first) + wrap_u * 3 + wrap_v;
  }

 private:
  void create_samplers(float max_anisotropy);
  uint32_t take(std::vector<uint32_t>& free, uint32_t& next, uint32_t limit, const char* what);

  VkDevice device_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipelineLayout pipeline_layout_ = VK_NULL_HANDLE;
  std::vector<VkSampler> samplers_;
  std::vector<uint32_t> free_sampled_, free_storage_;
  uint32_t next_sampled_ = 0, next_storage_ = 0;
};

}  // namespace gnomon
