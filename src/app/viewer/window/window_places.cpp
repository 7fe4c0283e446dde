#include "app/viewer/window/window_places.h"

#include <algorithm>

namespace gnomon::viewer {
namespace {

constexpr float k_margin = 8.0f;
// In heights of the font:
constexpr float k_panel_width = 28.0f, k_tools_width = 31.0f;
constexpr float k_title = 1.5f, k_closed_sections = 18.0f;
// Between panel and tools, for picture and map; with less the tools begin folded.
constexpr float k_least_middle = 200.0f;

Place between(vec2 corner, vec2 end) { return {corner, glm::max(end - corner, vec2(0.0f))}; }

}  // namespace

WindowPlaces first_places(vec2 screen, float letter) {
  const vec2 end = screen - k_margin;
  const auto width = [&](float letters) { return std::min(letters * letter, screen.x - 2.0f * k_margin); };
  WindowPlaces places;
  const float panel_height = std::max(0.62f * screen.y, std::min(screen.y - 2.0f * k_margin, 400.0f));
  places.panel = {vec2(k_margin), {width(k_panel_width), panel_height}};
  const float middle = places.panel.end().x + k_margin, room = end.x - middle;
  // Where there is little room they are narrower, where there is none the panel stands below their title.
  places.panel_folded = room < k_least_middle;
  const float tools_width = places.panel_folded ? width(k_tools_width) : std::min(width(k_tools_width), room),
              tools_left = end.x - tools_width;
  places.tools_folded = tools_left - k_margin - middle < k_least_middle;
  if (places.panel_folded) {
    const float shift = k_title * letter + k_margin;
    places.panel.corner.y += shift, places.panel.size.y = std::min(places.panel.size.y, end.y - places.panel.corner.y);
  }
  places.tools = {{tools_left, k_margin}, {tools_width, (places.tools_folded ? k_title : k_closed_sections) * letter}};
  const float below_tools = places.tools.end().y + k_margin;
  if (!places.tools_folded) {
    const vec2 map_size = glm::min(vec2(380.0f, 440.0f), vec2(tools_left - k_margin - middle, 0.8f * screen.y));
    places.map = {{middle, end.y - map_size.y}, map_size};
    places.pick = between({tools_left, std::max(below_tools, end.y - 560.0f)}, end);
    return places;
  }
  // One above the other, right of the panel; where that leaves nothing to read, over the panel.
  const float left = end.x - middle >= k_least_middle ? middle : k_margin;
  const float half = 0.5f * (below_tools + end.y - k_margin);
  places.map = between({left, below_tools}, {end.x, half});
  places.pick = between({left, half + k_margin}, end);
  return places;
}

}  // namespace gnomon::viewer
