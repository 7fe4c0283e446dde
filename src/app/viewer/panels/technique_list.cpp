#include "app/viewer/panels/technique_list.h"

#include <imgui.h>

#include <string>

#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

// What stands before the slash: the projection. Techniques without a map have none.
std::string group_of(const TechniqueSpec& spec) {
  const size_t slash = spec.name.find('/');
  return slash == std::string::npos ? "without a map" : spec.name.substr(0, slash);
}

}  // namespace

const TechniqueSpec* show_technique_list(const char* label, const char* name, const TechniqueSpec* shown, LightKind kind) {
  if (!ImGui::BeginCombo(label, shown ? shown->name.c_str() : "", ImGuiComboFlags_HeightLargest)) {
    note_widget(name);
    return nullptr;
  }
  const TechniqueSpec* chosen = nullptr;
  std::string group;
  for (const TechniqueSpec& spec : all_techniques()) {
    if (!spec.supports(kind)) continue;
    if (const std::string next = group_of(spec); next != group) {
      if (!group.empty()) ImGui::Separator();
      group = next;
      ImGui::TextDisabled("%s", group.c_str());
    }
    ImGui::Indent();
    const bool is_shown = shown && spec.name == shown->name;
    if (ImGui::Selectable(spec.name.c_str(), is_shown)) chosen = &spec;
    note_widget(name, spec.name);
    if (is_shown && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    ImGui::Unindent();
    if (!ImGui::IsItemHovered()) continue;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30.0f);
    ImGui::TextUnformatted(spec.summary.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  ImGui::EndCombo();
  return chosen;
}

}  // namespace gnomon::viewer
