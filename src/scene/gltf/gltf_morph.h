// Morph targets: what a shape adds to the vertices of a part.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// Differences to the part's own values, one per vertex; an empty array changes nothing.
struct MorphTarget {
  std::vector<vec3> positions, normals, tangents;
};

// Adds weight * target for every pair; targets beyond the weights have weight 0. Normals and tangents are no unit vectors
// after it.
void morph(MeshPart& part, std::span<const MorphTarget> targets, std::span<const float> weights);

}  // namespace gnomon
