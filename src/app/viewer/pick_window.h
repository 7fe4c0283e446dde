// Everything about one pixel, in a window that follows the picture.
#pragma once

#include <optional>
#include <string>

#include "lab/point_reference.h"
#include "lab/reason.h"
#include "shadow/technique.h"

namespace gnomon::viewer {

// What is known of the picked pixel in the last frame.
struct Picked {
  uvec2 pixel = uvec2(0);
  PickFacts facts;
  Reason reason;
  std::string object;  // name
  std::string technique;
};

// Whose picture the pixel shows, where two sides are beside each other. The first is what is explained.
enum class PickedSide { only, first, second };

// `open` is set to false when the user closes it.
void show_pick_window(const Picked& picked, PickedSide side, bool& open);

}  // namespace gnomon::viewer
