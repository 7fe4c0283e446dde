// Lights over the picture: a mark at each, handles at the chosen one, a sky to place the sun in.
#pragma once

#include "app/viewer/lights/light_list.h"
#include "app/viewer/window/screen_space.h"

namespace gnomon::viewer {

class LightGizmo {
 public:
  // Draws below the panels. True when the user moved the chosen light, which is then changed. A click on another light chooses
  // it.
  bool show(std::vector<ListedLight>& lights, size_t& chosen, const ScreenSpace& screen);
  // Whether the mouse is at a handle, or drags one: it then means nothing else.
  bool has_mouse() const { return hovered_ != Handle::none || dragged_ != Handle::none; }

 private:
  enum class Handle { none, x, y, z, place, target, sky };

  void draw_marks(const std::vector<ListedLight>& lights, size_t& chosen, const ScreenSpace& screen);
  bool show_sun(Light& sun, const ScreenSpace& screen);
  bool show_lamp(ListedLight& listed, const ScreenSpace& screen);
  // Starts and ends drags; true while `handle` is dragged.
  bool drags(Handle handle, vec2 at, float reach_px);

  Handle hovered_ = Handle::none, dragged_ = Handle::none;
  vec2 grip_px_ = vec2(0.0f);  // from the handle to where it was gripped
};

}  // namespace gnomon::viewer
