#include "app/viewer/section.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

constexpr float k_margin = 8.0f;
constexpr float k_width_in_letters = 31.0f;  // heights of the font

float column_width() { return std::min(k_width_in_letters * ImGui::GetFontSize(), ImGui::GetIO().DisplaySize.x - 2.0f * k_margin); }

}  // namespace

float section_width() { return column_width() - 2.0f * ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize; }

bool begin_section(const char* title, bool open_at_first) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = column_width();
  ImGui::SetNextWindowPos({screen.x - k_margin, k_margin}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(screen.y - 2.0f * k_margin, 60.0f)});
  // On a narrow window the other panel is below.
  ImGui::SetNextWindowCollapsed(screen.x < 2.0f * width, ImGuiCond_FirstUseEver);
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
