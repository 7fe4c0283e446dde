// Animations of a glTF file at one moment: transforms of nodes and weights of morph targets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_hierarchy.h"

namespace gnomon {

// A value of `width` numbers over time. Of a cubic spline each key has three values: in-tangent, value, out-tangent.
struct GltfCurve {
  enum class Interpolation { step, linear, cubic_spline };
  Interpolation interpolation = Interpolation::linear;
  bool rotation = false;     // quaternions: the shorter way round, unit
  std::vector<float> times;  // seconds, rising; at least one
  size_t width = 0;
  std::vector<float> values;

  // Before the first key and after the last it stands still.
  std::vector<float> at(double time_s) const;
};

using MorphWeights = std::map<int, std::vector<float>>;  // by node

// Moves the nodes to where the animation of that name or number (empty: the first) has them, and returns the weights that it
// gives. A file without animations stays as it is. Usage error for a name that is not there.
MorphWeights apply_animation(const GltfDocument& document, const GltfAccessors& accessors, const std::string& animation,
                             double time_s, GltfHierarchy& hierarchy);

}  // namespace gnomon
