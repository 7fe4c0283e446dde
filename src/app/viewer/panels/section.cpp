#include "app/viewer/panels/section.h"

#include <imgui.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

ImVec2 to_imgui(vec2 v) { return {v.x, v.y}; }

// Whether the window is to be arranged: it was not yet shown on a screen of that size.
bool is_new_here(const char* name) {
  static std::map<std::string, vec2> arranged_for;  // as Dear ImGui's own state, of the one interface
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  return std::exchange(arranged_for[name], vec2(screen.x, screen.y)) != vec2(screen.x, screen.y);
}

}  // namespace

WindowPlaces places_on_screen() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  return first_places({screen.x, screen.y}, ImGui::GetFontSize());
}

void appear_at(const char* name, const Place& place, bool folded) {
  if (!is_new_here(name)) return;
  ImGui::SetNextWindowPos(to_imgui(place.corner));
  ImGui::SetNextWindowSize(to_imgui(place.size));
  ImGui::SetNextWindowCollapsed(folded);
}

float section_width() {
  const ImGuiStyle& style = ImGui::GetStyle();
  return places_on_screen().tools.size.x - 2.0f * style.WindowPadding.x - style.ScrollbarSize;
}

bool begin_section(const char* title, bool open_at_first) {
  const WindowPlaces places = places_on_screen();
  const Place& tools = places.tools;
  ImGui::SetNextWindowPos(to_imgui(tools.corner), ImGuiCond_Always);
  const float most = ImGui::GetIO().DisplaySize.y - 2.0f * tools.corner.y;
  ImGui::SetNextWindowSizeConstraints({tools.size.x, 0.0f}, {tools.size.x, std::max(most, 60.0f)});
  if (is_new_here("tools")) ImGui::SetNextWindowCollapsed(places.tools_folded);
  const bool shown = ImGui::Begin("tools", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
  bool open = false;
  if (shown) {
    note_window("tools");
    ImGui::SetNextItemOpen(open_at_first, ImGuiCond_Once);
    open = ImGui::CollapsingHeader(title);
    note_widget("section", title);
  }
  ImGui::PushID(title);  // labels of one section may be those of another
  ImGui::PushItemWidth(0.5f * section_width());
  return open;
}

void end_section() {
  ImGui::PopItemWidth();
  ImGui::PopID();
  ImGui::End();
}

}  // namespace gnomon::viewer
