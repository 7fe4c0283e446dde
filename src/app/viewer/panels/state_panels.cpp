#include "app/viewer/panels/state_panels.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/attempt.h"
#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {
void StatePanels::before_panels(ViewState& state, CameraRig& rig, Session& session, const Window& window, double seconds,
                                std::string& message) {
  now_s_ += seconds;
  const ImGuiIO& io = ImGui::GetIO();
  // A number that is being typed counts digit by digit: one step, as a drag is.
  history_.tick(now_s_, ImGui::IsAnyMouseDown() || io.WantTextInput);
  if (!io.WantTextInput) {
    const bool shift = window.held(GLFW_KEY_LEFT_SHIFT) || window.held(GLFW_KEY_RIGHT_SHIFT);
    const bool z = window.control_held() && window.pressed(GLFW_KEY_Z), y = window.control_held() && window.pressed(GLFW_KEY_Y);
    wants_undo_ = wants_undo_ || (z && !shift);
    wants_redo_ = wants_redo_ || (z && shift) || y;
    camera_placed_ = cameras_.keys(state, rig, session, window) || camera_placed_;
  }
  if (ImGui::IsMouseDoubleClicked(0) && !io.WantCaptureMouse && !has_mouse() && cameras_.focus(rig, session)) {
    keep_lens(state, session);
    state.view.camera = rig.camera().text();
    user_moves_camera();
  }
  attempt(message, [&] { camera_placed_ = paths_.advance(state, session, rig, seconds) || camera_placed_; });
}

void StatePanels::show(ViewState& state, CameraRig& rig, Session& session, std::string& message) {
  const bool lights_open = begin_section("Lights");
  if (lights_open) attempt(message, [&] { lights_.show(state, session); });
  end_section();
  if (begin_section("Camera")) camera_placed_ = cameras_.show(state, rig, session) || camera_placed_;
  end_section();
  if (begin_section("Paths")) attempt(message, [&] { paths_.show(state, session, rig); });
  end_section();
  if (begin_section("Presets, undo")) {
    const auto button = [](const char* label, bool enabled) {
      ImGui::BeginDisabled(!enabled);
      const bool clicked = ImGui::Button(label);
      ImGui::EndDisabled();
      return clicked;
    };
    wants_undo_ = button("undo (Ctrl+Z)", history_.can_undo()) || wants_undo_;
    note_widget("undo");
    ImGui::SameLine();
    wants_redo_ = button("redo (Ctrl+Y)", history_.can_redo()) || wants_redo_;
    note_widget("redo");
    attempt(message, [&] { presets_.show(state, session); });
  }
  end_section();
  if (lights_open) attempt(message, [&] { lights_.show_gizmo(state, session); });
  cameras_.show_centre(rig, session);
}

std::optional<ViewState> StatePanels::travel(const ViewState& state) {
  const bool undo = std::exchange(wants_undo_, false) && history_.can_undo();
  const bool redo = std::exchange(wants_redo_, false) && history_.can_redo();
  if (!undo && !redo) return std::nullopt;
  ViewState next = undo ? history_.undo() : history_.redo();
  next.view.size = state.view.size;
  camera_placed_ = true;
  paths_.stop_camera();
  return next;
}

void StatePanels::follow_camera(CameraRig& rig, const Session& session) {
  if (std::exchange(camera_placed_, false)) rig.stand_at(session.camera());
}

}  // namespace gnomon::viewer
