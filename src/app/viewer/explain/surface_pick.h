// The place that a pixel shows.
#pragma once

#include <optional>

#include "lab/view/session.h"

namespace gnomon::viewer {

// `part`: of the picture, 0, 0 at its upper left corner, 1, 1 at its lower right one. nullopt for the sky. Reads the whole
// surface of the last frame, and draws what was given up of it: for a click, not for every frame.
std::optional<vec3> surface_at(Session& session, vec2 part);

}  // namespace gnomon::viewer
