#include "app/viewer/status_file.h"

#include <imgui.h>

#include <cmath>
#include <cstdlib>

#include "base/file.h"

namespace gnomon::viewer {
namespace {

StatusFile* file_in_use = nullptr;  // where note_widget finds it

}  // namespace

StatusFile::StatusFile() {
  const char* path = std::getenv("GNOMON_VIEW_STATUS");
  if (!path || !*path) return;
  path_ = path;
  file_in_use = this;
}

StatusFile::~StatusFile() {
  if (file_in_use == this) file_in_use = nullptr;
}

void StatusFile::write(const ViewStatus& status) {
  const auto pair = [](uvec2 size) { return nlohmann::json::array({size.x, size.y}); };
  const nlohmann::json json = {{"frame", ++frame_},
                               {"window_size", pair(status.window_size)},
                               {"picture_size", pair(status.picture_size)},
                               {"command", status.command},
                               {"camera", status.camera},
                               {"message", status.message},
                               {"vsync", status.vsync},
                               {"loading", status.loading},
                               {"full_maps", status.full_maps},
                               {"widgets", std::exchange(widgets_, nlohmann::json::object())},
                               {"texts", std::exchange(texts_, nlohmann::json::object())}};
  write_file(path_, json.dump(1));
}

// {left, top, right, bottom}, in pixels of the window.
void note_area(std::string_view name, std::string_view part, vec2 min_px, vec2 max_px) {
  std::string key(name);
  if (!part.empty()) key.append(":").append(part);
  file_in_use->widgets_[key] = {std::lround(min_px.x), std::lround(min_px.y), std::lround(max_px.x), std::lround(max_px.y)};
}

void note_widget(std::string_view name, std::string_view part) {
  if (!file_in_use) return;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const ImVec2 middle = {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
  if (ImGui::IsRectVisible(middle, {middle.x + 1.0f, middle.y + 1.0f})) note_area(name, part, {min.x, min.y}, {max.x, max.y});
}

void note_window(std::string_view name) {
  if (!file_in_use) return;
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  note_area(name, {}, {at.x, at.y}, {at.x + size.x, at.y + size.y});
}

void note_point(std::string_view name, vec2 at_px) {
  if (file_in_use) note_area(name, {}, at_px - 2.0f, at_px + 2.0f);
}

void note_text(std::string_view name, std::string_view text) {
  if (file_in_use) file_in_use->texts_[std::string(name)] = text;
}

}  // namespace gnomon::viewer
