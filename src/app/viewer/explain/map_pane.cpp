// The picture is drawn by a callback of Dear ImGui's with a pipeline of its own: 1.86 knows one texture, its font's. So the map
// is read where it lies, and what overlaps overlaps as windows do.
#include "app/viewer/explain/map_pane.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"
#include "app/viewer/window/interface.h"
#include "gpu/pipeline_target.h"

namespace gnomon::viewer {
namespace {

constexpr float k_most_zoom = 64.0f, k_zoom_per_notch = 1.25f;
constexpr uint32_t k_probe_block = 32;  // texels along a side of a work group

uint32_t kind_of(const Image& image) {
  switch (image.info().format) {
    case VK_FORMAT_D32_SFLOAT:
      return image.info().samples > 1 ? k_map_depth_samples : k_map_depth;
    case VK_FORMAT_R32_UINT:
      return k_map_objects;
    case VK_FORMAT_R32G32_UINT:
      return k_map_table;
    default:
      return k_map_values;
  }
}

std::string value_text(const vec4& value, uint32_t kind) {
  if (kind == k_map_objects) return value.x == 0.0f ? "no object" : fmt::format("object {:.0f}", value.x - 1.0f);
  if (kind == k_map_depth || kind == k_map_depth_samples) return value.x >= 1.0f ? "no caster" : fmt::format("{:.6f}", value.x);
  return fmt::format("{:.5g}  {:.5g}  {:.5g}  {:.5g}", value.x, value.y, value.z, value.w);
}

}  // namespace

MapPane::MapPane(Device& device, VkRenderPass render_pass)
    : device_(device), result_(device, "map probe", sizeof(MapProbe), BufferMemory::readback) {
  make_pipelines(render_pass);
}

void MapPane::make_pipelines(VkRenderPass render_pass) {
  probe_begins_ = make_compute_pipeline(device_, "shadow/map/map_probe.comp", {1});
  probe_ = make_compute_pipeline(device_, "shadow/map/map_probe.comp", {0});
  GraphicsPipelineInfo info;
  info.vertex = "app/viewer/explain/map_pane.vert";
  info.fragment = "app/viewer/explain/map_pane.frag";
  info.colour_formats = {k_window_format};
  pipeline_ = make_graphics_pipeline(device_, info, {.render_pass = render_pass});
}

const Image& MapPane::image_of(const ShadowMapView& map) const {
  if (content_ == Content::objects && map.object_ids) return *map.object_ids;
  return content_ == Content::filtered ? *map.filtered : *map.depth;
}

MapProbe MapPane::probe() const {
  result_.invalidate();
  MapProbe probe;
  std::memcpy(&probe, result_.mapped(), sizeof probe);
  return probe;
}

void MapPane::show(const std::optional<ShadowMapView>& map, const std::string& light_name, uint32_t& layer, bool& open) {
  appear_at("map", places_on_screen().map);
  // The part behind ### is the window's identity, whatever light it shows.
  shown_ =
      ImGui::Begin(fmt::format("shadow map{}{}###map", light_name.empty() ? "" : " of ", light_name).c_str(), &open) && map;
  if (!map) ImGui::TextDisabled("this technique has no map");
  if (shown_) {
    note_window("map_window");
    choose(*map, layer);
    show_picture(image_of(*map), ImGui::GetIO().DisplayFramebufferScale.x);
  }
  ImGui::End();
}

void MapPane::choose(const ShadowMapView& map, uint32_t& layer) {
  layer = std::min(layer, map.layers - 1);
  int number = static_cast<int>(layer);
  ImGui::SetNextItemWidth(0.3f * ImGui::GetContentRegionAvail().x);
  if (ImGui::SliderInt("layer", &number, 0, static_cast<int>(map.layers) - 1, "%d", ImGuiSliderFlags_AlwaysClamp))
    layer = static_cast<uint32_t>(number);
  ImGui::SameLine();
  if (ImGui::SmallButton("whole")) zoom_ = 0.0f;
  const auto content = [&](const char* name, Content which) {
    ImGui::SameLine();
    if (ImGui::RadioButton(name, content_ == which)) content_ = which;
  };
  if (map.filtered == map.depth && !map.object_ids) {
    content_ = Content::depth;
  } else {
    ImGui::NewLine();
    content("depth", Content::depth);
    if (map.filtered != map.depth) content(map.filter.c_str(), Content::filtered);
    if (map.object_ids) content("objects", Content::objects);
  }
  const uint32_t kind = kind_of(image_of(map));
  if (kind == k_map_depth || kind == k_map_depth_samples) channels_ = 0;
  if (kind == k_map_values || kind == k_map_table) {
    const char* const names[] = {"R", "G", "B", "A", "RGB"};
    for (uint32_t i = 0; i <= k_channels_rgb; ++i) {
      if (i > 0) ImGui::SameLine();
      if (ImGui::RadioButton(names[i], channels_ == i)) channels_ = i;
    }
  }
  if (kind == k_map_objects) return;
  ImGui::Checkbox("automatic range", &automatic_);
  if (automatic_) return;
  ImGui::SetNextItemWidth(-1.0f);
  float range[] = {least_, most_};
  if (ImGui::DragFloat2("##range", range, 0.001f, 0.0f, 0.0f, "%.5g")) least_ = range[0], most_ = range[1];
}

void MapPane::show_picture(const Image& image, float scale) {
  const auto size = static_cast<float>(image.info().width);
  const uint32_t kind = kind_of(image);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const vec2 pane(std::max(room.x, 32.0f), std::max(room.y - ImGui::GetTextLineHeightWithSpacing(), 32.0f));
  ImGui::InvisibleButton("map", {pane.x, pane.y});
  note_widget("map_picture");
  const float whole = std::min(pane.x, pane.y) / size;
  const float zoom = zoom_ > 0.0f ? zoom_ : whole;
  if (zoom_ <= 0.0f) middle_ = vec2(0.5f);
  vec2 origin = vec2(at.x, at.y) + 0.5f * pane - middle_ * size * zoom;
  const vec2 pointer(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActive()) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    middle_ -= vec2(moved.x, moved.y) / (size * zoom);
    if (moved.x != 0.0f || moved.y != 0.0f) zoom_ = zoom;
  }
  if (const float wheel = ImGui::GetIO().MouseWheel; hovered && wheel != 0.0f) {
    zoom_ = std::clamp(zoom * std::pow(k_zoom_per_notch, wheel), 0.5f * whole, k_most_zoom);
    // The texel under the pointer stays there.
    const vec2 place = (pointer - origin) / (size * zoom);
    middle_ = place - (pointer - vec2(at.x, at.y) - 0.5f * pane) / (size * zoom_);
  }
  origin = vec2(at.x, at.y) + 0.5f * pane - middle_ * size * (zoom_ > 0.0f ? zoom_ : whole);
  arguments_.origin_px = origin * scale;
  arguments_.pixels_per_texel = (zoom_ > 0.0f ? zoom_ : whole) * scale;

  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(at, {at.x + pane.x, at.y + pane.y}, true);
  list->AddCallback(&MapPane::draw, this);
  list->AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  list->PopClipRect();

  const vec2 texel = glm::floor((pointer - origin) * scale / arguments_.pixels_per_texel);
  const bool over = hovered && texel.x >= 0.0f && texel.y >= 0.0f && texel.x < size && texel.y < size;
  const MapProbe probe = probed_ ? this->probe() : MapProbe{};
  if (over && probed_ && texel_ == uvec2(texel)) {
    const std::string text = fmt::format("texel {}, {}: {}", texel_.x, texel_.y, value_text(probe.value, kind));
    ImGui::TextUnformatted(text.c_str());
    note_text("texel", text);
  } else {
    ImGui::TextDisabled("%.0f x %.0f texels; wheel and drag", static_cast<double>(size), static_cast<double>(size));
  }
  texel_ = over ? uvec2(texel) : uvec2(0);
  if (!automatic_ || !probed_) return;
  least_ = most_ = order_restored(probe.least[channels_ == k_channels_rgb ? 0 : channels_]);
  for (uint32_t channel = 0; channel < 4; ++channel) {
    if (channels_ != k_channels_rgb ? channel != channels_ : channel == 3) continue;
    least_ = std::min(least_, order_restored(probe.least[channel]));
    most_ = std::max(most_, order_restored(probe.most[channel]));
  }
  // An empty layer has no range.
  if (!(least_ < most_)) least_ = 0.0f, most_ = 1.0f;
}

void MapPane::record(Recorder& recorder, const std::optional<ShadowMapView>& map, uint32_t layer) {
  uses_.clear();
  probed_ = std::exchange(shown_, false) && map;
  if (!probed_) return;
  const Image& image = image_of(*map);
  const uint32_t size = image.info().width, kind = kind_of(image), shown_layer = std::min(layer, map->layers - 1);
  arguments_.size = size;
  arguments_.image = image.sampled(), arguments_.kind = kind, arguments_.layer = shown_layer;
  arguments_.channels = kind == k_map_objects ? 0 : channels_;
  arguments_.least = least_, arguments_.most = most_;
  uses_.emplace_back(image, Use::sampled);
  const MapProbeArguments probe = {
      result_.address(), image.sampled(), kind, shown_layer, size, std::min(texel_.x, size - 1), std::min(texel_.y, size - 1)};
  recorder.pass("window/map probe", PassStage::other, {{image, Use::compute_read}, {result_, Use::compute_write}},
                [&](Commands& commands) {
                  commands.bind(probe_begins_);
                  commands.push(probe);
                  commands.dispatch({1, 1}, {8, 8});
                  if (!automatic_) return;
                  commands.compute_barrier();
                  commands.bind(probe_);
                  commands.push(probe);
                  commands.dispatch(uvec2(size), uvec2(k_probe_block));
                });
}

// Inside the interface's render pass, whose command buffer Interface::draw left in Dear ImGui's user data.
void MapPane::draw(const ImDrawList*, const ImDrawCmd* command) {
  const auto& pane = *static_cast<const MapPane*>(command->UserCallbackData);
  if (pane.uses_.empty()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const auto commands = static_cast<VkCommandBuffer>(io.UserData);
  const vec2 scale(io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y),
      target = vec2(io.DisplaySize.x, io.DisplaySize.y) * scale;
  const vec2 low = glm::max(vec2(command->ClipRect.x, command->ClipRect.y) * scale, vec2(0.0f));
  const vec2 high = glm::min(vec2(command->ClipRect.z, command->ClipRect.w) * scale, target);
  if (high.x <= low.x || high.y <= low.y) return;
  const VkRect2D scissor = {{static_cast<int32_t>(low.x), static_cast<int32_t>(low.y)},
                            {static_cast<uint32_t>(high.x - low.x), static_cast<uint32_t>(high.y - low.y)}};
  const VkPipelineLayout layout = pane.device_.pipeline_layout();
  const auto& sets = pane.device_.bindless().sets();
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pane.pipeline_.handle());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 2, sets.data(), 0, nullptr);
  vkCmdSetScissor(commands, 0, 1, &scissor);
  vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
  vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_ALL, 0, sizeof pane.arguments_, &pane.arguments_);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace gnomon::viewer
