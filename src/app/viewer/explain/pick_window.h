// Everything about one pixel, in a window that follows the picture.
#pragma once

#include <optional>
#include <string>

#include "lab/explain/point_reference.h"
#include "lab/explain/reason.h"
#include "shadow/technique.h"

namespace gnomon::viewer {

// Whose picture the pixel shows, where two sides are beside each other. Where that is the reference, the first side is
// explained.
enum class PickedSide { only, first, second, reference };

// What is known of the picked pixel in the last frame.
struct Picked {
  uvec2 pixel = uvec2(0);
  PickedSide side = PickedSide::only;
  size_t light = 0;        // of the frame
  std::string light_name;  // empty where the frame has no other
  PickFacts facts;
  Reason reason;
  std::string object;  // name
  std::string technique;
};

// `open` is set to false when the user closes it.
void show_pick_window(const Picked& picked, bool& open);

}  // namespace gnomon::viewer
