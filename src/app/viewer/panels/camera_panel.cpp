#include "app/viewer/panels/camera_panel.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/explain/surface_pick.h"
#include "app/viewer/status_file.h"
#include "app/viewer/window/screen_space.h"

namespace gnomon::viewer {
namespace {

void orbit(CameraRig& rig, Session& session, bool on) {
  if (on && !rig.orbits()) {
    if (const auto point = surface_at(session, vec2(0.5f))) rig.focus(*point);
  }
  rig.set_orbits(on);
}

}  // namespace

bool CameraPanel::show(ViewState& state, CameraRig& rig, Session& session) {
  bool orbits = rig.orbits();
  if (ImGui::Checkbox("orbit (O, or Alt and drag)", &orbits)) orbit(rig, session, orbits);
  note_widget("orbit");
  ImGui::TextDisabled("double-click: look at that point, orbit it");
  bool chosen = false;
  const auto& cameras = session.scene().cameras;
  if (cameras.empty() && ImGui::Selectable("of the whole scene", state.view.camera.empty()))
    choose_scene_camera(state, ""), chosen = true;
  for (size_t i = 0; i < cameras.size(); ++i) {
    const std::string number = std::to_string(i),
                      label = fmt::format("{}##camera{}", cameras[i].name.empty() ? number : cameras[i].name, i);
    const bool shown =
        state.view.camera == number || state.view.camera == cameras[i].name || (i == 0 && state.view.camera.empty());
    if (ImGui::Selectable(label.c_str(), shown)) choose_scene_camera(state, number), chosen = true;
  }
  for (const int number : saved_.numbers()) {
    ImGui::PushID(number);
    if (ImGui::SmallButton("x")) saved_.remove(number);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("forget it");
    ImGui::SameLine();
    if (ImGui::Selectable(fmt::format("saved {} (key {})", number, number).c_str()))
      chosen = saved_.recall(number, state) || chosen;
    note_widget("saved", std::to_string(number));
    ImGui::PopID();
  }
  const int free = saved_.free_number();
  if (ImGui::SmallButton(fmt::format("save as {} (Ctrl+{})", free, free).c_str())) saved_.store(free, state);
  return chosen;
}

bool CameraPanel::keys(ViewState& state, CameraRig& rig, Session& session, const Window& window) {
  if (window.pressed(GLFW_KEY_O) && !window.control_held()) orbit(rig, session, !rig.orbits());
  for (int number = 1; number <= 9; ++number) {
    if (!window.pressed(GLFW_KEY_0 + number)) continue;
    if (!window.control_held()) return saved_.recall(number, state);
    saved_.store(number, state);
  }
  return false;
}

bool CameraPanel::focus(CameraRig& rig, Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto point = surface_at(session, vec2(io.MousePos.x, io.MousePos.y) / vec2(io.DisplaySize.x, io.DisplaySize.y));
  if (!point) return false;
  rig.focus(*point);
  return true;
}

void CameraPanel::show_centre(const CameraRig& rig, Session& session) const {
  note_text("orbit", rig.orbits() ? "on" : "off");
  if (!rig.orbits() || !rig.centre()) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const auto at = ScreenSpace(session.frame().camera(), {size.x, size.y}).to_screen(*rig.centre());
  if (!at) return;
  const float arm = 0.6f * ImGui::GetFontSize();
  for (const auto& [colour, width] : {std::pair(IM_COL32(0, 0, 0, 200), 3.0f), std::pair(IM_COL32(255, 255, 255, 255), 1.0f)}) {
    ImGui::GetBackgroundDrawList()->AddLine({at->x - arm, at->y}, {at->x + arm, at->y}, colour, width);
    ImGui::GetBackgroundDrawList()->AddLine({at->x, at->y - arm}, {at->x, at->y + arm}, colour, width);
  }
}

}  // namespace gnomon::viewer
