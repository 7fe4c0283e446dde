// Where the viewer's windows are when they first appear: beside each other wherever the screen has room.
#pragma once

#include "base/maths.h"

namespace gnomon::viewer {

struct Place {
  vec2 corner, size;  // pixels; the upper left one

  vec2 end() const { return corner + size; }
};

struct WindowPlaces {
  Place panel;
  bool panel_folded;  // where it would leave no picture
  Place tools;        // with all its sections closed; they open downward
  bool tools_folded;  // to their title, which leaves room for the others
  Place pick, map;
};

// `letter`: height of the font.
WindowPlaces first_places(vec2 screen, float letter);

}  // namespace gnomon::viewer
