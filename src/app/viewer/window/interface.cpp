// Dear ImGui 1.86 and later: what differs between versions is here.
#include "app/viewer/window/interface.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include "gpu/recorder.h"

namespace gnomon::viewer {
namespace {

// The interface keeps one set, that of its font.
constexpr VkDescriptorPoolSize k_pool_size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 16};

void check(VkResult result) { vk_check(result, "Dear ImGui"); }

// In pixels of the target.
struct Background {
  VkRect2D area;
  ImU32 colour;
};

// The rectangle that a list of commands begins with, if it is one of a single opaque colour on whole pixels: a window's
// background.
std::optional<Background> background_of(const ImDrawList& list, const ImDrawData& data, uvec2 target) {
  constexpr unsigned k_indices = 6;
  if (list.CmdBuffer.empty() || list.CmdBuffer[0].UserCallback || list.CmdBuffer[0].ElemCount < k_indices) return std::nullopt;
  const ImDrawCmd& command = list.CmdBuffer[0];
  const ImDrawIdx* indices = &list.IdxBuffer[static_cast<int>(command.IdxOffset)];
  const ImDrawVert* corners = &list.VtxBuffer[static_cast<int>(command.VtxOffset)];
  const ImDrawVert &first = corners[indices[0]], &opposite = corners[indices[2]];
  const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
  for (unsigned i = 0; i < k_indices; ++i) {
    const ImDrawVert& corner = corners[indices[i]];
    const bool on_corner = (corner.pos.x == first.pos.x || corner.pos.x == opposite.pos.x) &&
                           (corner.pos.y == first.pos.y || corner.pos.y == opposite.pos.y);
    if (!on_corner || corner.col != first.col || corner.uv.x != white.x || corner.uv.y != white.y) return std::nullopt;
  }
  if (first.col >> IM_COL32_A_SHIFT != 0xFF) return std::nullopt;
  const auto pixels = [&](const ImVec2& at) {
    return vec2((at.x - data.DisplayPos.x) * data.FramebufferScale.x, (at.y - data.DisplayPos.y) * data.FramebufferScale.y);
  };
  const vec2 min = pixels(first.pos), max = pixels(opposite.pos);
  if (glm::floor(min) != min || glm::floor(max) != max) return std::nullopt;
  const ivec2 from = glm::clamp(ivec2(min), ivec2(0), ivec2(target)), to = glm::clamp(ivec2(max), ivec2(0), ivec2(target));
  if (to.x <= from.x || to.y <= from.y) return std::nullopt;
  return Background{{{from.x, from.y}, {static_cast<uint32_t>(to.x - from.x), static_cast<uint32_t>(to.y - from.y)}},
                    first.col};
}

// Inside the render pass, in the place of the rectangle; its data is a Background.
void clear_background(const ImDrawList*, const ImDrawCmd* command) {
  const Background& background = *static_cast<const Background*>(command->UserCallbackData);
  const ImVec4 colour = ImGui::ColorConvertU32ToFloat4(background.colour);
  VkClearAttachment clear = {VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
  clear.clearValue.color = {{colour.x, colour.y, colour.z, colour.w}};
  const VkClearRect rect = {background.area, 0, 1};
  vkCmdClearAttachments(static_cast<VkCommandBuffer>(ImGui::GetIO().UserData), 1, &clear, 1, &rect);
}

// Blending a window's whole background is most of what an interface costs on a CPU; clearing it costs little anywhere. What is
// returned must last until the lists have been drawn.
std::deque<Background> clear_backgrounds(ImDrawData& data, uvec2 target) {
  std::deque<Background> cleared;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    ImDrawList& list = *data.CmdLists[i];
    const auto background = background_of(list, data, target);
    if (!background) continue;
    ImDrawCmd clear;
    clear.UserCallback = clear_background;
    clear.UserCallbackData = &cleared.emplace_back(*background);
    list.CmdBuffer[0].IdxOffset += 6;
    list.CmdBuffer[0].ElemCount -= 6;
    list.CmdBuffer.push_front(clear);
  }
  return cleared;
}

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
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 1.0f;
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
  const auto cleared = clear_backgrounds(*ImGui::GetDrawData(), size);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
  vkCmdEndRenderPass(commands);
}

// ImGui closes popups by Escape only where keys also move between widgets, which here walk.
void Interface::close_popup() {
  const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
}

bool Interface::takes_keys() const { return ImGui::GetIO().WantTextInput; }
bool Interface::takes_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
float Interface::wheel() const { return ImGui::GetIO().MouseWheel; }

}  // namespace gnomon::viewer
