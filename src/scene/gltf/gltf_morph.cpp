// Morph targets: what a shape adds to the vertices of a part.
#include "scene/gltf/gltf_morph.h"

#include <algorithm>

namespace gnomon {
namespace {

template <class T>
void add(std::vector<T>& values, const std::vector<vec3>& differences, float weight) {
  const size_t count = std::min(values.size(), differences.size());  // a part without normals ignores theirs
  for (size_t i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) values[i][c] += weight * differences[i][c];
  }
}

}  // namespace

void morph(MeshPart& part, std::span<const MorphTarget> targets, std::span<const float> weights) {
  for (size_t i = 0; i < std::min(targets.size(), weights.size()); ++i) {
    if (weights[i] == 0.0f) continue;
    add(part.positions, targets[i].positions, weights[i]);
    add(part.normals, targets[i].normals, weights[i]);
    add(part.tangents, targets[i].tangents, weights[i]);
  }
}

}  // namespace gnomon
