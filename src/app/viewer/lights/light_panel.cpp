#include "app/viewer/lights/light_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/explain/surface_pick.h"
#include "app/viewer/status_file.h"
#include "lab/view/light_text.h"
#include "scene/path.h"

namespace gnomon::viewer {
namespace {

constexpr float k_degree = k_pi / 180.0f;
// Of a sun that counts as standing on a sun path: more than the step between the hours that are looked at.
constexpr float k_on_path = 1.0f * k_degree;

// An angle that is kept in radians, in degrees.
bool degrees(const char* label, float& radians, float min, float max, const char* help) {
  float value = radians / k_degree;
  const bool changed = ImGui::SliderFloat(label, &value, min, max, "%.3g", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  if (changed) radians = value * k_degree;
  return changed;
}

bool length(const char* label, float& metres, float max, float scale_m, const char* help) {
  const bool changed = ImGui::DragFloat(label, &metres, 0.002f * scale_m, 0.0f, max, "%.4g", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  return changed;
}

// Over what the middle of the picture shows, where one sees it.
ListedLight new_light(LightKind kind, Session& session) {
  const CameraData& camera = session.frame().camera();
  const float usual_m = 0.3f * std::max(session.scene().bounds().radius(), 1e-3f);
  const vec3 target = surface_at(session, vec2(0.5f)).value_or(camera.eye_ws + usual_m * camera.forward_ws);
  return usual_light(kind, target, std::max(glm::length(target - camera.eye_ws), 0.01f * usual_m));
}

}  // namespace

void LightPanel::show(ViewState& state, Session& session) {
  ImGui::Checkbox("handles in the picture", &gizmo_on_);
  list(state, session);
  auto lights = lights_of(state, session.chosen_lights());
  chosen_ = std::min(chosen_, lights.size() - 1);
  ListedLight& listed = lights[chosen_];
  ImGui::PushItemWidth(0.52f * ImGui::GetContentRegionAvail().x);
  if (named_ != chosen_) {
    named_ = chosen_;
    name_[listed.light.name.copy(name_, sizeof name_ - 1)] = '\0';
  }
  ImGui::InputText("name", name_, sizeof name_);
  note_widget("light_name");
  const bool renamed = ImGui::IsItemDeactivatedAfterEdit();
  if (!ImGui::IsItemActive()) named_ = ~size_t{0};  // as it is in the next frame
  if (renamed) listed.light.name = name_;
  const bool changed = edit(listed, session) || renamed;
  ImGui::PopItemWidth();
  if (changed) set_light(state, session.chosen_lights(), chosen_, listed);
}

void LightPanel::list(ViewState& state, Session& session) {
  const auto lights = lights_of(state, session.chosen_lights());
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i].light;
    const std::string label = fmt::format("{} ({})##light{}", light.name, light_kind_name(light.kind), i);
    if (ImGui::Selectable(label.c_str(), i == chosen_)) chosen_ = i;
    note_widget("lights", light.name);
  }
  for (const auto& [label, kind] : {std::pair("+ sun", LightKind::directional), std::pair("+ point", LightKind::point),
                                    std::pair("+ spot", LightKind::spot), std::pair("+ projector", LightKind::projector)}) {
    if (kind != LightKind::directional) ImGui::SameLine();
    const bool clicked = ImGui::SmallButton(label);
    note_widget("add_light", light_kind_name(kind));
    if (!clicked) continue;
    add_light(state, session.chosen_lights(), new_light(kind, session));
    chosen_ = state.view.lights.size() - 1;
  }
  if (lights.size() > 1) {
    ImGui::SameLine();
    if (ImGui::SmallButton("remove")) remove_light(state, session.chosen_lights(), std::min(chosen_, lights.size() - 1));
    note_widget("remove_light");
  }
}

bool LightPanel::edit(ListedLight& listed, const Session& session) {
  Light& light = listed.light;
  const float scale_m = std::max(session.scene().bounds().radius(), 1e-3f);
  bool changed = light.kind == LightKind::directional ? edit_sun(light, session) : edit_lamp(listed, session);
  changed = ImGui::ColorEdit3("colour", &light.colour.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR) || changed;
  light.colour = glm::max(light.colour, vec3(0.0f));
  const char* unit = light.parallel() ? "intensity [lux]" : "intensity [cd]";
  changed = ImGui::DragFloat(unit, &light.intensity, std::max(0.01f * light.intensity, 1e-3f), 0.0f, 1e9f, "%.4g",
                             ImGuiSliderFlags_AlwaysClamp) ||
            changed;
  if (light.parallel()) {
    changed =
        degrees("size [degree]", light.angular_diameter, 0.0f, 60.0f, "angular diameter of the disc; 0 makes shadows hard") ||
        changed;
  } else {
    changed =
        length("radius [m]", light.radius, 1e4f, 0.1f * scale_m, "of the shining sphere; 0 makes shadows hard") || changed;
    changed = length("range [m]", light.range, 1e6f, scale_m, "where its light ends; 0: nowhere") || changed;
  }
  return changed;
}

bool LightPanel::edit_sun(Light& sun, const Session& session) {
  const glm::dvec2 angles = sun_angles(sun.direction);
  auto azimuth = static_cast<float>(angles.x), elevation = static_cast<float>(angles.y);
  bool turned = ImGui::SliderFloat("azimuth [degree]", &azimuth, -180.0f, 180.0f, "%.1f", ImGuiSliderFlags_AlwaysClamp);
  note_widget("azimuth");
  turned = ImGui::SliderFloat("elevation [degree]", &elevation, -90.0f, 90.0f, "%.1f", ImGuiSliderFlags_AlwaysClamp) || turned;
  if (turned) sun.direction = sun_direction(azimuth, elevation);
  if (session.scene().sun_paths.empty()) return turned;
  const SunPath& path = session.scene().sun_paths.front();
  const NearestHour nearest = nearest_hour(path, sun.direction);
  auto hour = static_cast<float>(nearest.hour);
  const auto minutes = static_cast<int>(60.0f * hour + 0.5f);
  const bool on_path = nearest.off < k_on_path;
  const std::string clock =
      on_path ? fmt::format("{}:{:02}", minutes / 60, minutes % 60) : fmt::format("not on '{}'", path.name);
  const bool chosen =
      ImGui::SliderFloat("time of day", &hour, static_cast<float>(path.first_hour), static_cast<float>(path.last_hour),
                         clock.c_str(), ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  note_widget("time_of_day");
  note_text("time_of_day", clock);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip(
        on_path ? "on the sun path '%s', which also sets colour and intensity"
                : "this sun stands elsewhere; a drag puts it on the sun path '%s', which also sets colour and intensity",
        path.name.c_str());
  }
  if (chosen) {
    const SunState state = sun_at(path, static_cast<double>(hour));
    sun.direction = state.direction, sun.colour = state.colour, sun.intensity = state.intensity;
  }
  return turned || chosen;
}

bool LightPanel::edit_lamp(ListedLight& listed, const Session& session) {
  Light& light = listed.light;
  const float scale_m = std::max(session.scene().bounds().radius(), 1e-3f), step = 0.002f * scale_m;
  vec3 target = listed.target();
  const bool aims = light.kind != LightKind::point;
  bool changed = ImGui::DragFloat3("position [m]", &light.position.x, step, 0.0f, 0.0f, "%.3g");
  if (aims) {
    changed = ImGui::DragFloat3("target [m]", &target.x, step, 0.0f, 0.0f, "%.3g") || changed;
    if (changed) listed.aim_at(target);
  }
  if (light.kind == LightKind::spot) {
    if (degrees("outer cone [degree]", light.outer_cone, 0.1f, 90.0f, "half angle: outside it is dark")) {
      light.inner_cone = std::min(light.inner_cone, light.outer_cone);
      changed = true;
    }
    changed = degrees("inner cone [degree]", light.inner_cone, 0.0f, light.outer_cone / k_degree,
                      "half angle: inside it is bright") ||
              changed;
  }
  if (light.kind == LightKind::projector && length("beam [m]", light.beam_radius, 1e6f, scale_m, "radius of the beam")) {
    light.beam_radius = std::max(light.beam_radius, 1e-3f);
    changed = true;
  }
  return changed;
}

void LightPanel::show_gizmo(ViewState& state, Session& session) {
  if (!gizmo_on_) return;
  auto lights = lights_of(state, session.chosen_lights());
  chosen_ = std::min(chosen_, lights.size() - 1);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ScreenSpace screen(session.frame().camera(), {size.x, size.y});
  const size_t before = chosen_;
  if (gizmo_.show(lights, chosen_, screen)) set_light(state, session.chosen_lights(), before, lights[before]);
}

}  // namespace gnomon::viewer
