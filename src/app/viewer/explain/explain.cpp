#include "app/viewer/explain/explain.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/viewer/explain/legend.h"
#include "app/viewer/explain/light_lines.h"
#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"
#include "base/error.h"

namespace gnomon::viewer {
namespace {

const char* overlay_title(uint32_t overlay) {
  switch (overlay) {
    case k_overlay_layers:
      return "layers (cascades, faces)";
    case k_overlay_texels:
      return "texel grid";
    case k_overlay_footprint:
      return "pixels per texel";
    case k_overlay_flags:
      return "casters and receivers";
    case k_overlay_overdraw:
      return "overdraw";
    default:
      return "no overlay";
  }
}

void crosshair(const vec2& at) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const auto& [colour, width] : {std::pair(IM_COL32(0, 0, 0, 180), 3.0f), std::pair(IM_COL32(255, 255, 255, 255), 1.0f)}) {
    for (const vec2& way : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)}) {
      const vec2 from = at + 4.0f * way, to = at + 14.0f * way;
      list.AddLine({from.x, from.y}, {to.x, to.y}, colour, width);
    }
  }
}

// Empty where the frame has no other light.
std::string name_among_several(Session& session, size_t light) {
  const auto lights = session.frame().lights();
  return lights.size() > 1 ? lights[light].name : std::string();
}

vec2 screen_size() { return {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y}; }

}  // namespace

Explain::Explain(Device& device, VkRenderPass render_pass, ExplainOptions& options, SharedReference& rays)
    : rays_(rays), explainer_(device), map_pane_(device, render_pass), options_(options) {}

void Explain::rebuild(VkRenderPass render_pass) {
  explainer_.forget_shaders();
  map_pane_.make_pipelines(render_pass);
}

uvec2 Explain::pixel(const Session& session) const {
  return glm::min(uvec2(*place_ * vec2(session.options().size)), session.options().size - 1u);
}

PickedSide Explain::picked_side() const {
  if (divider_ >= 1.0f) return PickedSide::only;
  if (place_->x < divider_) return PickedSide::first;
  return second_is_explained_ ? PickedSide::second : PickedSide::reference;
}

void Explain::show(Session& session, const TechniqueSet& techniques) {
  light_ = std::min(light_, session.frame().lights().size() - 1);
  panel(session, techniques);
  if (picked_) {
    bool open = true;
    show_pick_window(*picked_, open);
    if (!open) place_.reset(), picked_.reset();
  }
  if (!options_.map_open) return;
  map_pane_.show(techniques.techniques()[light_]->shadow_map(), name_among_several(session, light_), options_.map_layer,
                 options_.map_open);
}

void Explain::handle_keys(const Window& window) {
  if (ImGui::GetIO().WantTextInput || window.control_held()) return;
  if (window.pressed(GLFW_KEY_V)) options_.overlay = (options_.overlay + 1) % k_overlay_count;
  if (window.pressed(GLFW_KEY_L)) options_.lines = !options_.lines;
  if (window.pressed(GLFW_KEY_M)) options_.map_open = !options_.map_open;
  if (window.pressed(GLFW_KEY_P)) pick_mode_ = !pick_mode_;
}

void Explain::handle_pick(Session& session) {
  const uvec2 size = session.options().size;
  if (options_.pick) {
    if (options_.pick->x >= size.x || options_.pick->y >= size.y) {
      fail_usage("--pick {},{}: the picture has {} x {} pixels", options_.pick->x, options_.pick->y, size.x, size.y);
    }
    place_ = (vec2(*options_.pick) + 0.5f) / vec2(size);
    options_.pick.reset();
  }
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return;
  const bool click = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && pick_mode_;
  if (!click && !ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) return;
  place_ = glm::clamp(vec2(io.MousePos.x, io.MousePos.y) / screen_size(), 0.0f, 0.9999f);
  pick_mode_ = false;
}

void Explain::panel(Session& session, const TechniqueSet& techniques) {
  if (begin_section("Explain", options_.lines || options_.overlay != k_overlay_none)) {
    const auto lights = session.frame().lights();
    const auto light_label = [&](size_t i) { return fmt::format("{}##{}", lights[i].name, i); };
    if (lights.size() > 1) {
      if (ImGui::BeginCombo("of light", light_label(light_).c_str())) {
        for (size_t i = 0; i < lights.size(); ++i) {
          if (ImGui::Selectable(light_label(i).c_str(), i == light_)) light_ = i;
          note_widget("explained_light", lights[i].name);
        }
        ImGui::EndCombo();
      } else {
        note_widget("explained_light");
      }
    }
    const bool has_map = techniques.techniques()[light_]->shadow_map().has_value();
    if (ImGui::BeginCombo("overlay (V)", overlay_title(options_.overlay))) {
      for (uint32_t overlay = 0; overlay < k_overlay_count; ++overlay) {
        if (ImGui::Selectable(overlay_title(overlay), overlay == options_.overlay)) options_.overlay = overlay;
        note_widget("overlay", overlay_title(overlay));
      }
      ImGui::EndCombo();
    } else {
      note_widget("overlay");
    }
    if (options_.overlay != k_overlay_none) {
      ImGui::SliderFloat("opacity", &options_.opacity, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
      const auto second = second_is_explained_ ? std::span<const ShadowView>(views_[1]) : std::span<const ShadowView>();
      const bool needs_map = overlay_needs_map(options_.overlay);
      if (needs_map && !has_map) remark(second_is_explained_ ? "the first side has no map" : "this technique has no map");
      if (!needs_map || has_map || !second.empty()) show_legend(options_.overlay, views_[0], second);
    }
    ImGui::Checkbox("light's views (L)", &options_.lines);
    note_widget("lines");
    bool hold = held_.has_value();
    if (options_.lines && (ImGui::SameLine(), ImGui::Checkbox("hold them", &hold))) {
      held_.reset();
      if (hold) held_ = Held{views_[0], session.frame().camera()};
    }
    ImGui::Checkbox("map (M)", &options_.map_open);
    note_widget("map");
    ImGui::SameLine();
    ImGui::Checkbox("pick (P)", &pick_mode_);
    note_widget("pick");
    remark("the middle button picks, too");
  }
  end_section();
}

void Explain::show_marks(Session& session) {
  handle_pick(session);
  note_text("overlay", overlay_title(options_.overlay));
  note_text("lines", options_.lines ? "on" : "off");
  note_text("pick_mode", pick_mode_ ? "on" : "off");
  if (pick_mode_) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (place_) crosshair(*place_ * screen_size());
  if (!options_.lines) return;
  const CameraData* cut = held_ ? &held_->camera : nullptr;
  draw_light_lines(*ImGui::GetBackgroundDrawList(), session.frame().camera(), screen_size(), held_ ? held_->views : views_[0],
                   cut, session.scene().bounds().radius());
}

void Explain::check_map_layer(const TechniqueSpec& spec, const std::optional<ShadowMapView>& map) {
  if (!std::exchange(options_.map_layer_given, false)) return;
  const uint32_t layer = options_.map_layer;
  if (!map) fail_usage("--map {}: {} has no shadow map; valid: with a technique that has one", layer, spec.name);
  if (layer < map->layers) return;
  const std::string valid = map->layers == 1 ? "0" : fmt::format("0 to {}", map->layers - 1);
  fail_usage("--map {}: valid for {} with these settings: {}", layer, spec.name, valid);
}

std::string Explain::overlay_drawn() const {
  return overlay_drawn_ ? fmt::format("the overlay '{}'", overlay_title(options_.overlay)) : std::string();
}

std::string Explain::key(size_t side) const {
  std::string key = fmt::format("{} {} {}", options_.overlay, options_.opacity, light_);
  if (side == 0 && options_.lines) key += " lines";
  if (picks_on(side)) key += fmt::format(" {},{}", place_->x, place_->y);
  return key;
}

void Explain::record(Recorder& recorder, Session& session, const TechniqueSet& techniques, size_t side) {
  light_ = std::min(light_, session.frame().lights().size() - 1);
  const Frame& frame = session.frame();
  const Technique& technique = *techniques.techniques()[light_];
  const auto map = technique.shadow_map();
  if (side == 0) check_map_layer(techniques.spec(light_), map);
  if (options_.overlay != k_overlay_none)
    explainer_.record_overlay(recorder, frame, light_, technique, options_.overlay, options_.opacity);
  if (picks_on(side)) explainer_.record_pick(recorder, frame, light_, technique, pixel(session));
  if ((side == 0 && options_.lines) || overlay_needs_map(options_.overlay)) explainer_.record_views(recorder, technique);
  if (side != 0) return;
  overlay_drawn_ = options_.overlay != k_overlay_none && (map || !overlay_needs_map(options_.overlay));
  map_pane_.record(recorder, map, options_.map_layer);
}

void Explain::collect(Session& session, const TechniqueSet& techniques, size_t side) {
  views_[side] = explainer_.views();
  if (!picks_on(side)) return;
  const TechniqueSpec& spec = techniques.spec(light_);
  Picked picked;
  picked.pixel = pixel(session);
  picked.side = picked_side();
  picked.light = light_;
  picked.light_name = name_among_several(session, light_);
  picked.technique = spec.name;
  const PickRecord& record = picked.facts.record = explainer_.picked();
  if (const auto map = techniques.techniques()[light_]->shadow_map()) {
    picked.facts.has_map = true;
    picked.facts.compares_depth = map->filtered == map->depth;
    picked.facts.stores_objects = map->object_ids != nullptr;
    picked.facts.unsettled = map->unsettled;
    picked.facts.front_face_culling = session.settings_of(spec, light_).at("bias").number("front_face_culling") != 0.0;
  }
  if (record.seen != 0) picked.object = session.scene().objects[record.object].name;
  picked_ = std::move(picked);
}

void Explain::judge(Session& session) {
  if (!place_ || !picked_) return;
  PickFacts& facts = picked_->facts;
  const auto lights = session.frame().lights();
  if (facts.record.seen != 0 && picked_->light < lights.size()) {
    if (!reference_) reference_ = std::make_unique<PointReference>(rays_);
    const uint32_t index = picked_->pixel.y * session.options().size.x + picked_->pixel.x;
    const SurfacePoint point = {facts.record.position_ws, facts.record.object, facts.record.normal_ws, index};
    if (const auto answer = reference_->answer(point, session.frame().camera().eye_ws, lights[picked_->light])) {
      facts.hard = answer->hard;
      facts.area = answer->area;
    }
  }
  picked_->reason = reason_of(facts);
}

}  // namespace gnomon::viewer
