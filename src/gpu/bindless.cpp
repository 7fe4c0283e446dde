// Layout, pool and samplers of the bindless set.
#include "gpu/bindless.h"

#include <array>

#include "base/error.h"

namespace gnomon {

namespace {

struct Binding {
  uint32_t set, binding;
  VkDescriptorType type;
  uint32_t count;
  VkDescriptorBindingFlags flags;
};

constexpr VkDescriptorBindingFlags k_partial = VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT;
constexpr VkDescriptorBindingFlags k_late = k_partial | VK_DESCRIPTOR_BINDING_UPDATE_AFTER_BIND_BIT;
// In the order of Bindless::Kind, then the samplers.
constexpr std::array<Binding, 4> k_bindings = {{
    {0, 0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, Bindless::k_max_images, k_late},
    {1, 0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, Bindless::k_max_images, k_late},
    {1, 1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, Bindless::k_max_storage_images, k_late},
    {0, 1, VK_DESCRIPTOR_TYPE_SAMPLER, Bindless::k_max_samplers, k_partial},
}};
constexpr const Binding& k_sampler_binding = k_bindings[3];

}  // namespace

Bindless::Bindless(VkDevice device, float max_anisotropy, VkShaderStageFlags stages) : device_(device) {
  create_layouts(stages);
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Binding& binding : k_bindings) sizes.push_back({binding.type, binding.count});
  VkDescriptorPoolCreateInfo pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_UPDATE_AFTER_BIND_BIT;
  pool.maxSets = 2;
  pool.poolSizeCount = static_cast<uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  vk_check(vkCreateDescriptorPool(device_, &pool, nullptr, &pool_), "vkCreateDescriptorPool");

  VkDescriptorSetAllocateInfo allocate = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = 2;
  allocate.pSetLayouts = set_layouts_.data();
  vk_check(vkAllocateDescriptorSets(device_, &allocate, sets_.data()), "vkAllocateDescriptorSets");
  create_samplers(max_anisotropy);
}

void Bindless::create_layouts(VkShaderStageFlags stages) {
  for (uint32_t set = 0; set < 2; ++set) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    std::vector<VkDescriptorBindingFlags> flags;
    for (const Binding& binding : k_bindings) {
      if (binding.set != set) continue;
      bindings.push_back({binding.binding, binding.type, binding.count, stages, nullptr});
      flags.push_back(binding.flags);
    }
    VkDescriptorSetLayoutBindingFlagsCreateInfo flags_info = {
        VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO};
    flags_info.bindingCount = static_cast<uint32_t>(flags.size());
    flags_info.pBindingFlags = flags.data();
    VkDescriptorSetLayoutCreateInfo layout = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, &flags_info};
    layout.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_UPDATE_AFTER_BIND_POOL_BIT;
    layout.bindingCount = static_cast<uint32_t>(bindings.size());
    layout.pBindings = bindings.data();
    vk_check(vkCreateDescriptorSetLayout(device_, &layout, nullptr, &set_layouts_[set]), "vkCreateDescriptorSetLayout");
  }
  const VkPushConstantRange range = {stages, 0, k_push_constant_bytes};
  VkPipelineLayoutCreateInfo pipeline = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  pipeline.setLayoutCount = 2;
  pipeline.pSetLayouts = set_layouts_.data();
  pipeline.pushConstantRangeCount = 1;
  pipeline.pPushConstantRanges = &range;
  vk_check(vkCreatePipelineLayout(device_, &pipeline, nullptr, &pipeline_layout_), "vkCreatePipelineLayout");
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
  VkSamplerCreateInfo anisotropic = base;
  anisotropic.anisotropyEnable = max_anisotropy > 1.0f;
  anisotropic.maxAnisotropy = max_anisotropy;
  constexpr VkSamplerAddressMode k_wraps[] = {VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                              VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT};
  VkSamplerCreateInfo nearest = base;
  nearest.magFilter = nearest.minFilter = VK_FILTER_NEAREST;
  nearest.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  GNOMON_ASSERT(infos.size() == k_sampler_material_first);
  for (VkSamplerCreateInfo info : {anisotropic, base, nearest}) {  // by k_material_*
    for (const auto u : k_wraps) {
      for (const auto v : k_wraps) {
        info.addressModeU = u;
        info.addressModeV = v;
        infos.push_back(info);
      }
    }
  }

  samplers_.resize(infos.size());
  std::vector<VkDescriptorImageInfo> images(infos.size());
  for (size_t i = 0; i < infos.size(); ++i) {
    vk_check(vkCreateSampler(device_, &infos[i], nullptr, &samplers_[i]), "vkCreateSampler");
    images[i].sampler = samplers_[i];
  }
  VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = sets_[k_sampler_binding.set];
  write.dstBinding = k_sampler_binding.binding;
  write.descriptorCount = static_cast<uint32_t>(images.size());
  write.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLER;
  write.pImageInfo = images.data();
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

Bindless::~Bindless() {
  for (const VkSampler sampler : samplers_) vkDestroySampler(device_, sampler, nullptr);
  vkDestroyPipelineLayout(device_, pipeline_layout_, nullptr);
  vkDestroyDescriptorPool(device_, pool_, nullptr);
  for (const VkDescriptorSetLayout layout : set_layouts_) vkDestroyDescriptorSetLayout(device_, layout, nullptr);
}

uint32_t Bindless::add(Kind kind, VkImageView view) {
  const Binding& binding = k_bindings[static_cast<size_t>(kind)];
  Slots& slots = slots_[static_cast<size_t>(kind)];
  if (slots.free.empty() && slots.next == binding.count)
    fail("more than {} images of one kind are in use at once", binding.count);
  uint32_t index = slots.next;
  if (slots.free.empty()) {
    // `remove` must not fail.
    if (slots.free.capacity() <= slots.next) slots.free.reserve(2 * size_t{slots.next} + 16);
    ++slots.next;
  } else {
    index = slots.free.back();
    slots.free.pop_back();
  }
  const bool storage = kind == Kind::storage;
  const VkDescriptorImageInfo image = {VK_NULL_HANDLE, view,
                                       storage ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = sets_[binding.set];
  write.dstBinding = binding.binding;
  write.dstArrayElement = index;
  write.descriptorCount = 1;
  write.descriptorType = binding.type;
  write.pImageInfo = &image;
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
  return index;
}

}  // namespace gnomon
