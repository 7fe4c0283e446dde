// Dear ImGui 1.86 and later: what differs between versions is here.
#include "app/viewer/interface.h"

#include <imgui.h>

#include <cmath>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include "gpu/recorder.h"

namespace gnomon::viewer {
namespace {

// The interface keeps one set, that of its font.
constexpr VkDescriptorPoolSize k_pool_size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 16};

void check(VkResult result) { vk_check(result, "Dear ImGui"); }

}  // namespace

Interface::Interface(Device& device, const Window& window) : device_(device) {
  VkDescriptorPoolCreateInfo pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  pool.maxSets = k_pool_size.descriptorCount;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &k_pool_size;
  vk_check(vkCreateDescriptorPool(device.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  make_render_pass();

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // nothing is left behind in the user's folder
  ImGui::StyleColorsDark();
  if (device.info().software) {
    // Corners and soft edges are some thousand small triangles, which a CPU draws slowly.
    ImGui::GetStyle().AntiAliasedFill = ImGui::GetStyle().AntiAliasedLines = false;
    ImGui::GetStyle().WindowBorderSize = 0.0f;
  } else {
    ImGui::GetStyle().WindowRounding = ImGui::GetStyle().FrameRounding = 3.0f;
  }
  // The default font is of 13 pixels.
  const float scale = window.interface_scale();
  ImFontConfig font;
  font.SizePixels = std::round(13.0f * scale);
  ImGui::GetIO().Fonts->AddFontDefault(&font);
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo info = {};
  info.Instance = device.instance();
  info.PhysicalDevice = device.physical();
  info.Device = device.handle();
  info.QueueFamily = device.queue_family();
  info.Queue = device.queue();
  info.DescriptorPool = pool_;
  info.MinImageCount = info.ImageCount = 2;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check;
#if IMGUI_VERSION_NUM >= 19030
  info.RenderPass = render_pass_;
  ImGui_ImplVulkan_Init(&info);
#else
  ImGui_ImplVulkan_Init(&info, render_pass_);
#endif
#if IMGUI_VERSION_NUM < 19000
  run_once(device, [](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

Interface::~Interface() {
  vkDeviceWaitIdle(device_.handle());
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  vkDestroyRenderPass(device_.handle(), render_pass_, nullptr);
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
}

void Interface::make_render_pass() {
  VkAttachmentDescription colour = {};
  colour.format = k_window_format;
  colour.samples = VK_SAMPLE_COUNT_1_BIT;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  colour.initialLayout = colour.finalLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
  const VkAttachmentReference reference = {0, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass = {};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkRenderPassCreateInfo info = {VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = 1;
  info.pAttachments = &colour;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  vk_check(vkCreateRenderPass(device_.handle(), &info, nullptr, &render_pass_), "vkCreateRenderPass");
}

void Interface::begin_frame() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Interface::end_frame() { ImGui::Render(); }

void Interface::draw(VkCommandBuffer commands, VkFramebuffer framebuffer, uvec2 size) {
  VkRenderPassBeginInfo begin = {VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  begin.renderPass = render_pass_;
  begin.framebuffer = framebuffer;
  begin.renderArea.extent = {size.x, size.y};
  ImGui::GetIO().UserData = commands;  // for callbacks that draw by themselves
  vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
  vkCmdEndRenderPass(commands);
}

bool Interface::takes_keys() const { return ImGui::GetIO().WantTextInput; }
bool Interface::takes_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
float Interface::wheel() const { return ImGui::GetIO().MouseWheel; }

}  // namespace gnomon::viewer
