// What 32-bit floats can draw: scenes that would end as an empty picture, or one without shadows, say so first.
#pragma once

#include "scene/scene.h"

namespace gnomon {

// Throws Error where there is nothing to draw, or where a coordinate is too large for rays and rasteriser alike, naming the
// object.
void check_drawable(const Scene& scene);

// Warns of objects that cast and reach so far out that the rest of the scene is next to nothing beside them. After the user
// has said what casts (scene/casting.h).
void warn_of_strays(const Scene& scene);

}  // namespace gnomon
