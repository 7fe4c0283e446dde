// Triangles of one polygon of an OBJ file: any number of corners, concave ones included.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/maths.h"

namespace gnomon {

// A concave polygon costs the square of its corners: a limit against files made to take hours.
inline constexpr size_t k_max_concave_corners = 4096;

// Appends the polygon's size - 2 triangles, as indices into it, in its winding. A polygon without area (or one that
// intersects itself) still yields that many triangles. At least three corners; more than k_max_concave_corners only if convex:
// returns false where that does not hold.
bool triangulate(std::span<const vec3> polygon, std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace gnomon
