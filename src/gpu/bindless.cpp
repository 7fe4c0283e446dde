// Layout, pool and samplers of the bindless set.
#include "gpu/bindless.h"

#include <array>

#include "base/error.h"

namespace gnomon {

Bindless::Bindless(VkDevice device, float max_anisotropy, VkShaderStageFlags stages) : device_(device) {
  const std::array<VkDescriptorSetLayoutBinding, 3> bindings = {{
      {0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, k_max_images, stages, nullptr},
      {1, VK_DESCRIPTOR_TYPE_SAMPLER, k_max_samplers, stages, nullptr},
      {2, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, k_max_storage_images, stages, nullptr},
  }};
  constexpr VkDescriptorBindingFlags k_partial = VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT;
  constexpr VkDescriptorBindingFlags k_late = k_partial | VK_DESCRIPTOR_BINDING_UPDATE_AFTER_BIND_BIT;
  const std::array<VkDescriptorBindingFlags, 3> flags = {k_late, k_partial, k_late};
  VkDescriptorSetLayoutBindingFlagsCreateInfo flags_info = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO};
  flags_info.bindingCount = 3;
  flags_info.pBindingFlags = flags.data();
  VkDescriptorSetLayoutCreateInfo layout = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, &flags_info};
  layout.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_UPDATE_AFTER_BIND_POOL_BIT;
  layout.bindingCount = 3;
  layout.pBindings = bindings.data();
  vk_check(vkCreateDescriptorSetLayout(device_, &layout, nullptr, &set_layout_), "vkCreateDescriptorSetLayout");

  const std::array<VkDescriptorPoolSize, 3> sizes = {{{VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, k_max_images},
                                                      {VK_DESCRIPTOR_TYPE_SAMPLER, k_max_samplers},
                                                      {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, k_max_storage_images}}};
  VkDescriptorPoolCreateInfo pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_UPDATE_AFTER_BIND_BIT;
  pool.maxSets = 1;
  pool.poolSizeCount = 3;
  pool.pPoolSizes = sizes.data();
  vk_check(vkCreateDescriptorPool(device_, &pool, nullptr, &pool_), "vkCreateDescriptorPool");

  VkDescriptorSetAllocateInfo allocate = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &set_layout_;
  vk_check(vkAllocateDescriptorSets(device_, &allocate, &set_), "vkAllocateDescriptorSets");

  const VkPushConstantRange range = {stages, 0, k_push_constant_bytes};
  VkPipelineLayoutCreateInfo pipeline = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  pipeline.setLayoutCount = 1;
  pipeline.pSetLayouts = &set_layout_;
  pipeline.pushConstantRangeCount = 1;
  pipeline.pPushConstantRanges = &range;
  vk_check(vkCreatePipelineLayout(device_, &pipeline, nullptr, &pipeline_layout_), "vkCreatePipelineLayout");
  create_samplers(max_anisotropy);
}

void Bindless::create_samplers(float max_anisotropy) {
  VkSamplerCreateInfo base = {VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  base.addressModeU = base.addressModeV = base.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  base.maxLod = VK_LOD_CLAMP_NONE;

  std::vector<VkSamplerCreateInfo> infos;
  infos.push_back(base);  // nearest_clamp
  base.magFilter = base.minFilter = VK_FILTER_LINEAR;
  base.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  infos.push_back(base);  // linear_clamp
  // Outside the map is lit: the white border is the farthest depth, and `reference <= stored` then holds.
  VkSamplerCreateInfo compare = base;
  compare.addressModeU = compare.addressModeV = compare.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  compare.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
  compare.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  compare.compareEnable = VK_TRUE;
  compare.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  infos.push_back(compare);  // depth_compare_linear
  compare.magFilter = compare.minFilter = VK_FILTER_NEAREST;
  infos.push_back(compare);  // depth_compare_nearest
  constexpr VkSamplerAddressMode k_wraps[] = {VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                              VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT};
  for (const auto u : k_wraps) {
    for (const auto v : k_wraps) {
      VkSamplerCreateInfo material = base;
      material.addressModeU = u;
      material.addressModeV = v;
      material.anisotropyEnable = max_anisotropy > 1.0f;
      material.maxAnisotropy = max_anisotropy;
      infos.push_back(material);
    }
  }

  samplers_.resize(infos.size());
  std::vector<VkDescriptorImageInfo> images(infos.size());
  for (size_t i = 0; i < infos.size(); ++i) {
    vk_check(vkCreateSampler(device_, &infos[i], nullptr, &samplers_[i]), "vkCreateSampler");
    images[i].sampler = samplers_[i];
  }
  VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = 1;
  write.descriptorCount = static_cast<uint32_t>(images.size());
  write.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLER;
  write.pImageInfo = images.data();
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

Bindless::~Bindless() {
  for (const VkSampler sampler : samplers_) vkDestroySampler(device_, sampler, nullptr);
  vkDestroyPipelineLayout(device_, pipeline_layout_, nullptr);
  vkDestroyDescriptorPool(device_, pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
}

uint32_t Bindless::take(std::vector<uint32_t>& free, uint32_t& next, uint32_t limit, const char* what) {
  if (!free.empty()) {
    const uint32_t index = free.back();
    free.pop_back();
    return index;
  }
  if (next == limit) fail("more than {} {} are in use at once", limit, what);
  return next++;
}

uint32_t Bindless::add_sampled(VkImageView view) {
  const uint32_t index = take(free_sampled_, next_sampled_, k_max_images, "sampled images");
  const VkDescriptorImageInfo image = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = 0;
  write.dstArrayElement = index;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  write.pImageInfo = &image;
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
  return index;
}

uint32_t Bindless::add_storage(VkImageView view) {
  const uint32_t index = take(free_storage_, next_storage_, k_max_storage_images, "storage images");
  const VkDescriptorImageInfo image = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL};
  VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = 2;
  write.dstArrayElement = index;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  write.pImageInfo = &image;
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
  return index;
}

}  // namespace gnomon
