#include "app/viewer/panels/scene_panel.h"

#include <imgui.h>

#include <functional>

#include "app/viewer/state/typed_scene.h"
#include "app/viewer/status_file.h"
#include "base/user_folder.h"
#include "scene/load.h"

namespace gnomon::viewer {

std::optional<std::string> ScenePanel::show(const std::string& shown_scene, const RecentFiles& recent) {
  std::optional<std::string> wanted;
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::BeginCombo("##scene", shown_scene.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const BuiltinScene& scene : builtin_scenes()) {
      if (ImGui::Selectable(scene.name.c_str(), scene.name == shown_scene)) wanted = scene.name;
      note_widget("scene", scene.name);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", scene.summary.c_str());
    }
    if (!recent.paths().empty()) ImGui::Separator();
    for (const std::string& path : recent.paths()) {
      if (ImGui::Selectable(path.c_str(), path == shown_scene)) wanted = path;
      note_widget("scene", path);
    }
    ImGui::EndCombo();
  } else {
    note_widget("scene");
  }
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputTextWithHint("##path", "path of an .obj, .gltf, .glb; or drop one", path_, sizeof path_,
                                                ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  note_widget("scene_path");
  if (const std::string typed = typed_scene(path_, home_folder()); entered && !typed.empty()) wanted = typed;
  return wanted;
}

namespace {

void box_in_the_middle(const std::function<void()>& content) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({0.6f * screen.x, 0.0f});
  constexpr ImGuiWindowFlags k_plain =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##progress", nullptr, k_plain)) {
    content();
  }
  ImGui::End();
}

}  // namespace

void show_notice(const std::string& text) {
  box_in_the_middle([&] { ImGui::TextWrapped("%s", text.c_str()); });
}

void show_progress(const std::string& text, double share) {
  box_in_the_middle([&] {
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::ProgressBar(static_cast<float>(share), {-1.0f, 0.0f});
  });
}

}  // namespace gnomon::viewer
