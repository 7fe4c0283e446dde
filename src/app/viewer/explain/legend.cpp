#include "app/viewer/explain/legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

namespace gnomon::viewer {
namespace {

void entry(const vec3& colour, const std::string& text) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, to_colour(colour));
  ImGui::Dummy({side, side});
  ImGui::SameLine();
  ImGui::TextUnformatted(text.c_str());
}

// A ramp of colours from 0 to 1 with words below, evenly spread.
void bar(const std::vector<std::string>& words) {
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr int k_steps = 64;
  for (int i = 0; i < k_steps; ++i) {
    const float from = static_cast<float>(i) / k_steps, to = static_cast<float>(i + 1) / k_steps;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + from * width, at.y}, {at.x + to * width, at.y + height},
                                              to_colour(ramp_colour(0.5f * (from + to))));
  }
  for (size_t i = 0; i < words.size(); ++i) {
    const float text = ImGui::CalcTextSize(words[i].c_str()).x,
                share = static_cast<float>(i) / static_cast<float>(words.size() - 1);
    ImGui::GetWindowDrawList()->AddText({at.x + share * (width - text), at.y + height + 2.0f}, IM_COL32(230, 230, 230, 255),
                                        words[i].c_str());
  }
  ImGui::Dummy({width, 2.0f * height + 4.0f});
}

const char* flag_text(uint32_t flag) {
  switch (flag) {
    case k_flag_beyond:
      return "beyond the light's range, cone or beam";
    case k_flag_away:
      return "faces away from the light";
    case k_flag_outside:
      return "outside the map: lit";
    case k_flag_receiver:
      return "receives only, casts nothing";
    default:
      return "receives and casts";
  }
}

void show_layers_of(std::span<const ShadowView> views) {
  for (size_t i = 0; i < views.size(); ++i) {
    if (views[i].raster.in_use == 0) continue;
    const vec2 interval = views[i].interval_m;
    std::string text = fmt::format("layer {}", i);
    if (interval.y < 1e30f) text += fmt::format(": {:.1f} to {:.1f} m", interval.x, interval.y);
    entry(layer_colour(static_cast<uint32_t>(i)), text);
  }
}

void show_layers(std::span<const ShadowView> views, std::span<const ShadowView> second) {
  show_layers_of(views);
  if (second.empty()) return;
  remark("of the second side");
  show_layers_of(second);
}

}  // namespace

void remark(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text);
  ImGui::PopStyleColor();
}

uint32_t to_colour(const vec3& colour, float alpha) {
  return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, alpha});
}

void show_legend(uint32_t overlay, std::span<const ShadowView> views, std::span<const ShadowView> second) {
  switch (overlay) {
    case k_overlay_layers:
      return show_layers(views, second);
    case k_overlay_texels:
      remark("borders of texels; where they are small, of every 8th, 64th ...");
      return show_layers(views, second);
    case k_overlay_footprint:
      remark("side of a texel, in pixels");
      return bar({"1/8", "1/4", "1/2", "1", "2", "4", "8"});
    case k_overlay_flags:
      for (uint32_t flag = 0; flag < k_flag_count; ++flag) entry(flag_colour(flag), flag_text(flag));
      return;
    case k_overlay_overdraw:
      remark("how often the surface pass wrote the pixel");
      return bar({"1", "2", "3", "4", "5", "6", "7", "8"});
    default:
      return;
  }
}

}  // namespace gnomon::viewer
