#include "app/viewer/explain/pick_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/explain/legend.h"
#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

void row(const char* name, const std::string& value) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", value.c_str());
}

std::string vector_text(const vec3& v) { return fmt::format("{:.3f}, {:.3f}, {:.3f}", v.x, v.y, v.z); }

// Metres in texels, and as a length.
std::string in_texels(float metres, const PickedLayer& layer) {
  return fmt::format("{:.3g} texels, {}", metres / layer.texel_m, length_text(metres));
}

float stored_at_point(const PickedLayer& layer) { return layer.depths[k_pick_texels / 2]; }

std::string stored_text(const PickFacts& facts, const PickedLayer& layer) {
  const float depth = stored_at_point(layer);
  if (depth >= 1.0f) return "no caster";
  const vec2 uv = (vec2(layer.texel_x, layer.texel_y) + 0.5f) / layer.size;
  const vec4 ndc(uv * 2.0f - 1.0f, depth, 1.0f);
  const float linear = glm::dot(layer.linear_numerator, ndc) / glm::dot(layer.linear_denominator, ndc);
  std::string text = fmt::format("{:.6f}, {}", depth, length_text(layer.depth_near_m + linear * layer.depth_range_m));
  if (facts.stores_objects) text += layer.object == 0 ? ", no object" : fmt::format(", object {}", layer.object - 1);
  return text;
}

// The texels around the point: what lies behind a caster, what behind the receiver's own surface, and the kernel's reach.
void kernel_picture(const PickedLayer& layer, float radius) {
  const int side = static_cast<int>(k_pick_side), middle = side / 2;
  const float cell = std::floor(0.75f * ImGui::GetTextLineHeight());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < side * side; ++i) {
    // One texel alone: a kernel of no reach around its own centre.
    PickedLayer alone = layer;
    std::fill(std::begin(alone.depths), std::end(alone.depths), k_pick_outside);
    alone.depths[i] = layer.depths[i];
    const KernelContent content = kernel_content(alone, static_cast<float>(middle) + 1.0f);
    vec3 colour(0.35f, 0.75f, 0.35f);  // lit
    if (layer.depths[i] == k_pick_outside) colour = vec3(0.2f);
    if (content.hidden_by_bias > 0) colour = vec3(0.75f, 0.75f, 0.25f);
    if (content.occluding > 0) colour = content.own > 0 ? vec3(0.95f, 0.55f, 0.15f) : vec3(0.45f, 0.15f, 0.15f);
    const ImVec2 corner = {at.x + static_cast<float>(i % side) * cell, at.y + static_cast<float>(i / side) * cell};
    list.AddRectFilled(corner, {corner.x + cell - 1.0f, corner.y + cell - 1.0f}, to_colour(colour));
  }
  const vec2 point = (layer.uv * layer.size - vec2(layer.texel_x, layer.texel_y) + static_cast<float>(middle)) * cell;
  const float reach = std::min(radius, static_cast<float>(middle)) * cell;
  list.AddRect({at.x + point.x - reach, at.y + point.y - reach}, {at.x + point.x + reach, at.y + point.y + reach},
               IM_COL32(255, 255, 255, 255));
  list.AddCircleFilled({at.x + point.x, at.y + point.y}, 2.5f, IM_COL32(255, 255, 255, 255));
  ImGui::Dummy({static_cast<float>(side) * cell, static_cast<float>(side) * cell});
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetTooltip(
      "texels around the point; square: the filter's reach\ngreen: lit; brown: behind a caster;\norange: behind the receiver's "
      "own surface; yellow: hidden by the bias");
}

void show_layer(const PickFacts& facts, const PickedLayer& layer) {
  const PickRecord& record = facts.record;
  const std::string title = fmt::format("layer {} (weight {:.2f})", layer.layer, layer.weight);
  ImGui::PushStyleColor(ImGuiCol_Text, to_colour(layer_colour(layer.layer)));
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopStyleColor();
  if (ImGui::BeginTable(title.c_str(), 2, ImGuiTableFlags_RowBg)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 11.0f * ImGui::GetFontSize());
    ImGui::TableSetupColumn("value");
    row("map coordinates", fmt::format("{:.5f}, {:.5f}", layer.uv.x, layer.uv.y));
    row("texel", fmt::format("{}, {} of {:.0f}; {} wide, {:.2g} pixels", layer.texel_x, layer.texel_y, layer.size,
                             length_text(layer.texel_m), layer.pixels_per_texel));
    row("receiver's depth",
        fmt::format("{:.6f}, {}", layer.depth, length_text(layer.depth_near_m + layer.linear * layer.depth_range_m)));
    row("stored depth", stored_text(facts, layer));
    if (!facts.compares_depth) {
      row("filter stores",
          fmt::format("{:.5g}, {:.5g}, {:.5g}, {:.5g}", layer.stored.x, layer.stored.y, layer.stored.z, layer.stored.w));
    }
    row("bias", in_texels(layer.bias_linear * layer.depth_range_m, layer));
    const vec2 rise_m = glm::abs(layer.plane_linear_gradient) * (layer.depth_range_m / layer.size);
    row("plane's rise", fmt::format("{:.3g} texels a texel{}", (rise_m.x + rise_m.y) / layer.texel_m,
                                    layer.follows_plane != 0 && facts.compares_depth ? ", followed" : ", not followed"));
    row("filter's reach", in_texels(record.radius * layer.texel_m, layer));
    ImGui::EndTable();
  }
  kernel_picture(layer, record.radius);
}

struct SideText {
  const char* name;   // in the status file
  const char* title;  // of whom the window speaks
};

SideText side_text(PickedSide side) {
  switch (side) {
    case PickedSide::first:
      return {"first", " (first side)"};
    case PickedSide::second:
      return {"second", " (second side)"};
    case PickedSide::reference:
      return {"reference", " (first side)"};
    default:
      return {"only", ""};
  }
}

vec3 reason_colour(const PickFacts& facts, Cause cause) {
  if (cause == Cause::sky || cause == Cause::no_receiver) return vec3(0.7f);
  if (cause == Cause::none) return facts.hard ? vec3(0.5f, 0.9f, 0.5f) : vec3(0.85f);
  return {1.0f, 0.65f, 0.45f};
}

}  // namespace

void show_pick_window(const Picked& picked, bool& open) {
  const PickFacts& facts = picked.facts;
  const PickRecord& record = facts.record;
  appear_at("pick", places_on_screen().pick);
  // The part behind ### is the window's identity, whatever pixel it shows.
  const SideText text = side_text(picked.side);
  if (ImGui::Begin(
          fmt::format("pixel {}, {}: {}{}###pick", picked.pixel.x, picked.pixel.y, picked.technique, text.title).c_str(),
          &open)) {
    note_text("picked_side", text.name);
    note_text("picked_technique", picked.technique);
    if (picked.side == PickedSide::reference) {
      ImGui::TextColored({1.0f, 0.85f, 0.4f, 1.0f}, "The reference is shown here; this explains the first side.");
    }
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(reason_colour(facts, picked.reason.cause)));
    ImGui::TextWrapped("%s", picked.reason.text.c_str());
    note_window("pick_window");
    note_text("picked", fmt::format("{}, {}", picked.pixel.x, picked.pixel.y));
    note_text("reason", picked.reason.text);
    ImGui::PopStyleColor();
    note_text("picked_light", picked.light_name);
    if (record.seen != 0 && ImGui::BeginTable("point", 2, ImGuiTableFlags_RowBg)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 11.0f * ImGui::GetFontSize());
      ImGui::TableSetupColumn("value");
      if (!picked.light_name.empty()) row("light", picked.light_name);
      row("light that arrives", fmt::format("{:.3f}", record.answer));
      const auto known = [](const std::optional<float>& value) {
        return value ? fmt::format("{:.3f}", *value) : std::string("not yet known");
      };
      row("reference", fmt::format("{} (to the centre), {} (real size)", known(facts.hard), known(facts.area)));
      row("surface", fmt::format("{}{}", picked.object, record.casts != 0 ? "" : " (casts nothing)"));
      row("position", vector_text(record.position_ws));
      row("view depth", length_text(record.view_depth));
      row("angle to the light",
          fmt::format("{:.1f} degrees", std::acos(std::clamp(record.facing, -1.0f, 1.0f)) * 180.0f / k_pi));
      ImGui::EndTable();
    }
    for (uint32_t i = 0; record.seen != 0 && i < record.count; ++i) show_layer(facts, record.layers[i]);
  }
  ImGui::End();
}

}  // namespace gnomon::viewer
