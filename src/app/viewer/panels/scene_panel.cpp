#include "app/viewer/panels/scene_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "app/viewer/state/typed_scene.h"
#include "app/viewer/status_file.h"
#include "base/user_folder.h"
#include "scene/casting.h"
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

bool holds(const std::string& text, const std::string& part) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

}  // namespace

void ScenePanel::find_rows(const Scene& scene) {
  rows_.clear();
  std::set<std::string> names;  // things of one name are switched together
  for (const Object& object : scene.objects) {
    if (holds(object.name, filter_) && names.insert(object.name).second) rows_.push_back({object.name, &object, nullptr});
  }
  names.clear();
  for (const Material& material : scene.materials) {
    if (holds(material.name, filter_) && names.insert(material.name).second)
      rows_.push_back({material.name, nullptr, &material});
  }
  rows_of_ = &scene;
}

void ScenePanel::show_casting(ViewState& state, const Scene& scene) {
  const bool open = ImGui::TreeNode("who casts shadows");
  note_widget("casting");
  if (!open) return;
  ImGui::SetNextItemWidth(-1.0f);
  const bool typed = ImGui::InputTextWithHint("##cast_filter", "part of a name", filter_, sizeof filter_);
  note_widget("cast_filter");
  if (typed || rows_of_ != &scene) find_rows(scene);
  constexpr float k_shown_rows = 8.0f;
  if (ImGui::BeginChild("##casters", {0.0f, k_shown_rows * ImGui::GetFrameHeightWithSpacing()}, true)) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()));
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const Row& row = rows_[static_cast<size_t>(i)];
        bool casts = row.object ? object_casts(scene, *row.object) : material_casts(*row.material);
        ImGui::PushID(i);
        const std::string label = row.name + (row.object ? "" : " (material)");
        if (ImGui::Checkbox(label.c_str(), &casts)) set_cast(state.view.casts, row.name, casts);
        note_widget("cast", row.name);
        ImGui::PopID();
      }
    }
  }
  ImGui::EndChild();
  ImGui::BeginDisabled(state.view.casts.empty());
  if (ImGui::Button("as the scene says")) state.view.casts.clear();
  ImGui::EndDisabled();
  note_widget("cast_reset");
  ImGui::TreePop();
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
