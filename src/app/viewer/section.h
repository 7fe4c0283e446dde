// The column at the right: sections below each other, each with a bar that opens it. Closed ones cost next to nothing to draw.
#pragma once

#include "app/viewer/window_places.h"

namespace gnomon::viewer {

WindowPlaces places_on_screen();
// Once a frame, before any window: a screen of another size arranges them anew.
void arrange_windows();
// The next window, where it appears for the first time or is arranged anew.
void appear_at(const Place& place, bool folded = false);

// True while the section is open; end_section follows in any case. `open_at_first`: before the user opened or closed it.
bool begin_section(const char* title, bool open_at_first = false);
void end_section();

// Width of what stands in a section, pixels.
float section_width();

}  // namespace gnomon::viewer
