#include "app/viewer/panels/preset_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

#include "app/viewer/state/view_preset.h"
#include "app/viewer/status_file.h"
#include "base/file.h"

namespace gnomon::viewer {

void PresetPanel::show(ViewState& state, const Session& session) {
  const uvec2 size = session.options().size;
  ImGui::Checkbox("keep camera and lights", &keep_view_);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("of a preset take technique, samples and settings only");
  builtin_ones(state, session.scene());
  ImGui::SetNextItemWidth(0.45f * ImGui::GetContentRegionAvail().x);
  ImGui::InputText("##preset", file_, sizeof file_);
  note_widget("preset_file");
  ImGui::SameLine();
  const bool loads = ImGui::Button("load");
  note_widget("load_preset");
  if (loads) load(state, file_, session.scene());
  ImGui::SameLine();
  save(state, size);
  if (ImGui::Button("copy preset JSON")) {
    ImGui::SetClipboardText(preset_text(preset_of(state, size)).c_str());
    done_ = "copied: --preset reads it from a file";
  }
  note_text("preset", done_);
  if (!done_.empty()) ImGui::TextWrapped("%s", done_.c_str());
}

void PresetPanel::load(ViewState& state, const std::string& name, const Scene& scene) {
  const Preset preset = load_preset(name);
  ViewState next = with_preset(state, preset, keep_view_);
  // Its techniques may serve fewer kinds of light than there are.
  next.complete_techniques(choose_lights(scene, next.view, next.settings()), state.techniques);
  state = std::move(next);
  done_ = fmt::format("read {}", name);
  if (for_other_scene(state, preset))
    done_ += fmt::format("; it is for the scene {}: camera and lights stay as they are", *preset.scene);
}

void PresetPanel::builtin_ones(ViewState& state, const Scene& scene) {
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##builtin", "built-in presets", ImGuiComboFlags_HeightLarge)) {
    note_widget("builtin_preset");
    return;
  }
  for (const Preset& preset : builtin_presets()) {
    const bool chosen = ImGui::Selectable(preset.name.c_str());
    note_widget("builtin_preset", preset.name);
    if (chosen) load(state, preset.name, scene);
    if (!ImGui::IsItemHovered()) continue;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30.0f);
    ImGui::TextWrapped("%s\n\n%s\nscene %s", preset.description.c_str(), preset.source.c_str(),
                       preset.scene.value_or("any").c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  ImGui::EndCombo();
}

void PresetPanel::save(const ViewState& state, uvec2 size) {
  if (asks_ != file_) asks_.clear();  // another name was typed
  const bool replaces = !asks_.empty();
  const bool clicked = ImGui::Button(replaces ? "replace it?###save" : "save###save");
  note_widget("save_preset");
  if (!clicked) return;
  if (!replaces && std::filesystem::exists(file_)) {
    asks_ = file_;
    done_ = fmt::format("{} exists; click again to replace it", file_);
    return;
  }
  asks_.clear();
  write_file(file_, preset_text(preset_of(state, size)));
  done_ = fmt::format("wrote {}", file_);
}

}  // namespace gnomon::viewer
