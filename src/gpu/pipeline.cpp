// Pipeline creation.
#include "gpu/pipeline.h"

#include <array>
#include <cstring>
#include <functional>
#include <list>
#include <type_traits>

#include "base/error.h"
#include "gpu/pipeline_target.h"
#include "gpu/shader.h"

namespace gnomon {
namespace {

// A shader module that lives as long as the creation of its pipeline.
class ShaderModule {
 public:
  ShaderModule(Device& device, std::string_view name, const std::vector<uint32_t>& words) : device_(device.handle()) {
    VkShaderModuleCreateInfo info = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size() * sizeof(uint32_t);
    info.pCode = words.data();
    vk_check(vkCreateShaderModule(device_, &info, nullptr, &module_), fmt::format("vkCreateShaderModule({})", name));
  }
  ~ShaderModule() { vkDestroyShaderModule(device_, module_, nullptr); }
  ShaderModule(const ShaderModule&) = delete;
  ShaderModule& operator=(const ShaderModule&) = delete;

  VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, const VkSpecializationInfo* constants) const {
    VkPipelineShaderStageCreateInfo info = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = bit;
    info.module = module_;
    info.pName = "main";
    info.pSpecializationInfo = constants;
    return info;
  }

 private:
  VkDevice device_;
  VkShaderModule module_ = VK_NULL_HANDLE;
};

struct Specialisation {
  explicit Specialisation(const SpecialisationConstants& constants) {
    for (uint32_t i = 0; i < constants.size(); ++i) entries.push_back({i, i * 4, 4});
    info = {static_cast<uint32_t>(entries.size()), entries.data(), constants.size() * 4, constants.data()};
  }
  Specialisation(const Specialisation&) = delete;
  Specialisation& operator=(const Specialisation&) = delete;
  std::vector<VkSpecializationMapEntry> entries;
  VkSpecializationInfo info;
};

// What decides what a pipeline does, one after another.
class RecipeWriter {
 public:
  template <class T>
  RecipeWriter& add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T>);
    recipe_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  template <class T>
  RecipeWriter& add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
    return *this;
  }
  RecipeWriter& add(std::string_view text) {
    add(text.size());
    recipe_.append(text);
    return *this;
  }
  PipelineRecipe take() { return std::move(recipe_); }

 private:
  PipelineRecipe recipe_;
};

// A shader's name and a hash of its words, which change while the program runs (set_replaced_shaders).
struct Stage {
  explicit Stage(std::string_view shader) : name(shader), words(find_shader(shader)) {}
  void add_to(RecipeWriter& recipe) const {
    const std::string_view bytes(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(uint32_t));
    recipe.add(name).add(words.size()).add(std::hash<std::string_view>()(bytes));
  }
  ShaderModule module(Device& device) const { return {device, name, words}; }
  std::string_view name;
  std::vector<uint32_t> words;
};

Pipeline named(Pipeline pipeline, const Device& device, const std::string& name) {
  device.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline.handle()), name);
  return pipeline;
}

uint32_t align_up(uint32_t value, uint32_t alignment) { return (value + alignment - 1) / alignment * alignment; }

}  // namespace

void Pipeline::release() noexcept {
  if (!pipeline_) return;
  const VkPipeline last = device_->pipelines().keep(std::move(recipe_), pipeline_);
  if (last) device_->defer([device = device_->handle(), last] { vkDestroyPipeline(device, last, nullptr); });
  pipeline_ = VK_NULL_HANDLE;
}

void Pipeline::swap(Pipeline& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(pipeline_, other.pipeline_);
  std::swap(bind_point_, other.bind_point_);
  std::swap(recipe_, other.recipe_);
}

Pipeline make_compute_pipeline(Device& device, std::string_view shader, const SpecialisationConstants& constants) {
  const Stage stage(shader);
  RecipeWriter writer;
  stage.add_to(writer);
  PipelineRecipe recipe = writer.add(constants).take();
  if (const VkPipeline known = device.pipelines().take(recipe))
    return {device, known, VK_PIPELINE_BIND_POINT_COMPUTE, std::move(recipe)};
  const ShaderModule module = stage.module(device);
  const Specialisation specialisation(constants);
  VkComputePipelineCreateInfo info = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = module.stage(VK_SHADER_STAGE_COMPUTE_BIT, &specialisation.info);
  info.layout = device.pipeline_layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  device.reserve_defer();
  vk_check(vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
           fmt::format("vkCreateComputePipelines({})", shader));
  return named({device, pipeline, VK_PIPELINE_BIND_POINT_COMPUTE, std::move(recipe)}, device, std::string(shader));
}

Pipeline make_graphics_pipeline(Device& device, const GraphicsPipelineInfo& info) {
  return make_graphics_pipeline(device, info, {});
}

Pipeline make_graphics_pipeline(Device& device, const GraphicsPipelineInfo& info, const PipelineTarget& target) {
  const std::pair<const std::string&, VkShaderStageFlagBits> parts[] = {{info.vertex, VK_SHADER_STAGE_VERTEX_BIT},
                                                                        {info.geometry, VK_SHADER_STAGE_GEOMETRY_BIT},
                                                                        {info.fragment, VK_SHADER_STAGE_FRAGMENT_BIT}};
  std::vector<std::pair<Stage, VkShaderStageFlagBits>> shaders;
  for (const auto& [shader, bit] : parts) {
    if (!shader.empty()) shaders.emplace_back(shader, bit);
  }
  PipelineRecipe recipe;
  // A render pass belongs to somebody else, who may end it.
  if (!target.render_pass) {
    RecipeWriter writer;
    for (const auto& [stage, bit] : shaders) stage.add_to(writer.add(bit));
    recipe = writer.add(info.constants)
                 .add(info.colour_formats)
                 .add(info.depth_format)
                 .add(info.depth_compare)
                 .add(info.depth_clamp)
                 .add(target.adds)
                 .add(info.samples)
                 .add(info.view_mask)
                 .take();
  }
  if (const VkPipeline known = device.pipelines().take(recipe))
    return {device, known, VK_PIPELINE_BIND_POINT_GRAPHICS, std::move(recipe)};

  const Specialisation specialisation(info.constants);
  std::list<ShaderModule> modules;
  std::vector<VkPipelineShaderStageCreateInfo> stages;
  for (const auto& [stage, bit] : shaders) {
    stages.push_back(modules.emplace_back(device, stage.name, stage.words).stage(bit, &specialisation.info));
  }

  const VkPipelineVertexInputStateCreateInfo vertex_input = {VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly = {VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport = {VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster = {VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.depthClampEnable = info.depth_clamp && device.info().depth_clamp;
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo multisample = {VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = static_cast<VkSampleCountFlagBits>(info.samples);
  VkPipelineDepthStencilStateCreateInfo depth = {VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = info.depth_compare;
  VkPipelineColorBlendAttachmentState no_blend = {};
  no_blend.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  VkPipelineColorBlendAttachmentState add = no_blend;
  add.blendEnable = VK_TRUE;
  add.srcColorBlendFactor = add.dstColorBlendFactor = add.srcAlphaBlendFactor = add.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  const std::vector<VkPipelineColorBlendAttachmentState> attachments(info.colour_formats.size(), target.adds ? add : no_blend);
  VkPipelineColorBlendStateCreateInfo blend = {VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<uint32_t>(attachments.size());
  blend.pAttachments = attachments.data();
  const std::array<VkDynamicState, 3> dynamic_states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                                        VK_DYNAMIC_STATE_CULL_MODE};
  VkPipelineDynamicStateCreateInfo dynamic = {VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = static_cast<uint32_t>(dynamic_states.size());
  dynamic.pDynamicStates = dynamic_states.data();

  VkPipelineRenderingCreateInfo rendering = {VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.viewMask = info.view_mask;
  rendering.colorAttachmentCount = static_cast<uint32_t>(info.colour_formats.size());
  rendering.pColorAttachmentFormats = info.colour_formats.data();
  rendering.depthAttachmentFormat = info.depth_format;
  VkGraphicsPipelineCreateInfo create = {VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                         target.render_pass ? nullptr : &rendering};
  create.renderPass = target.render_pass;
  create.stageCount = static_cast<uint32_t>(stages.size());
  create.pStages = stages.data();
  create.pVertexInputState = &vertex_input;
  create.pInputAssemblyState = &assembly;
  create.pViewportState = &viewport;
  create.pRasterizationState = &raster;
  create.pMultisampleState = &multisample;
  create.pDepthStencilState = &depth;
  create.pColorBlendState = &blend;
  create.pDynamicState = &dynamic;
  create.layout = device.pipeline_layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  device.reserve_defer();
  const std::string name = info.vertex + (info.fragment.empty() ? "" : " + " + info.fragment);
  vk_check(vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &create, nullptr, &pipeline),
           fmt::format("vkCreateGraphicsPipelines({})", name));
  return named({device, pipeline, VK_PIPELINE_BIND_POINT_GRAPHICS, std::move(recipe)}, device, name);
}

RayPipeline::RayPipeline(Device& device, std::string_view raygen, std::string_view miss, std::string_view any_hit,
                         const SpecialisationConstants& constants)
    : device_(&device) {
  const DeviceInfo& limits = device.info();
  if (!limits.ray_tracing)
    fail_device("{}: '{}' has no ray-tracing pipeline (VK_KHR_ray_tracing_pipeline)", raygen, limits.name);
  const Specialisation specialisation(constants);
  const Stage shaders[] = {Stage(raygen), Stage(miss), Stage(any_hit)};
  const ShaderModule modules[] = {shaders[0].module(device), shaders[1].module(device), shaders[2].module(device)};
  const VkPipelineShaderStageCreateInfo stages[] = {modules[0].stage(VK_SHADER_STAGE_RAYGEN_BIT_KHR, &specialisation.info),
                                                    modules[1].stage(VK_SHADER_STAGE_MISS_BIT_KHR, nullptr),
                                                    modules[2].stage(VK_SHADER_STAGE_ANY_HIT_BIT_KHR, nullptr)};
  std::array<VkRayTracingShaderGroupCreateInfoKHR, 3> groups;
  for (uint32_t i = 0; i < 3; ++i) {
    groups[i] = {VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR};
    groups[i].type = VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR;
    groups[i].generalShader = i;
    groups[i].closestHitShader = groups[i].anyHitShader = groups[i].intersectionShader = VK_SHADER_UNUSED_KHR;
  }
  groups[2].type = VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR;
  groups[2].generalShader = VK_SHADER_UNUSED_KHR;
  groups[2].anyHitShader = 2;

  VkRayTracingPipelineCreateInfoKHR info = {VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR};
  info.stageCount = 3;
  info.pStages = stages;
  info.groupCount = 3;
  info.pGroups = groups.data();
  info.maxPipelineRayRecursionDepth = 1;
  info.layout = device.pipeline_layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  device.reserve_defer();
  const auto& functions = device.ray_tracing();
  vk_check(functions.create_pipelines(device.handle(), VK_NULL_HANDLE, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
           fmt::format("vkCreateRayTracingPipelinesKHR({})", raygen));
  pipeline_ = named({device, pipeline, VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR, {}}, device, std::string(raygen));

  // One record per region, each region at the base alignment.
  const uint32_t handle = limits.shader_group_handle_size;
  const uint32_t region = align_up(align_up(handle, limits.shader_group_handle_alignment), limits.shader_group_base_alignment);
  std::vector<std::byte> handles(size_t{3} * handle);
  vk_check(functions.group_handles(device.handle(), pipeline, 0, 3, handles.size(), handles.data()),
           "vkGetRayTracingShaderGroupHandlesKHR");
  table_ = Buffer(device, std::string(raygen) + " table", size_t{region} * 4, BufferMemory::upload,
                  VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR);
  const uint64_t base = (table_.address() + limits.shader_group_base_alignment - 1) / limits.shader_group_base_alignment *
                        limits.shader_group_base_alignment;
  const size_t offset = base - table_.address();
  for (size_t i = 0; i < 3; ++i) std::memcpy(table_.mapped() + offset + i * region, handles.data() + i * handle, handle);
  table_.flush();
  raygen_ = {base, region, region};
  miss_ = {base + region, region, region};
  hit_ = {base + 2 * uint64_t{region}, region, region};
}

void RayPipeline::trace(VkCommandBuffer commands, uint32_t width, uint32_t height) const {
  device_->ray_tracing().cmd_trace(commands, &raygen_, &miss_, &hit_, &callable_, width, height, 1);
}

}  // namespace gnomon
