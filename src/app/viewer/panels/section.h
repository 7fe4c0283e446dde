// The column at the right: sections below each other, each with a bar that opens it. Closed ones cost next to nothing to draw.
#pragma once

#include "app/viewer/window/window_places.h"

namespace gnomon::viewer {

WindowPlaces places_on_screen();
// The next window, where it appears for the first time on a screen of that size: another size arranges it anew. `name`: of the
// window.
void appear_at(const char* name, const Place& place, bool folded = false);

// True while the section is open; end_section follows in any case. `open_at_first`: before the user opened or closed it.
bool begin_section(const char* title, bool open_at_first = false);
void end_section();

// Width of what stands in a section, pixels.
float section_width();

}  // namespace gnomon::viewer
