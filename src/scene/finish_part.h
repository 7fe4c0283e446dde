// The last step of every loader.
#pragma once

#include "scene/scene.h"

namespace gnomon {

// Edges of surfaces whose file has no normals stay sharp above this angle.
inline constexpr float k_crease_angle = k_pi / 4.0f;

// Makes a part whole: `positions` and `indices` are there and in range; every other vertex array is either empty or has one
// entry per vertex. Missing normals are smooth up to the crease angle (also for glTF, which asks for flat ones: terrain and
// scans without normals are meant to look smooth); normals and tangents that are no unit vectors are mended; then optimise().
void finish_part(MeshPart& part);

}  // namespace gnomon
