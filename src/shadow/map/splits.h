// Where a view is cut into cascades (Zhang et al. 2006, "Parallel-split shadow maps", eq. 2 to 5).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "shadow/map/glsl/map_data.glsl"

namespace gnomon {

// End of slice i of m, i from 0 (= near) to m (= far): lambda 0 cuts equal lengths, 1 equal ratios. Metres; 0 < near < far.
inline float mixed_split(float near, float far, uint32_t i, uint32_t m, float lambda) {
  const float t = static_cast<float>(i) / static_cast<float>(m);
  const float logarithmic = near * std::pow(far / near, t), uniform = near + (far - near) * t;
  return lambda * logarithmic + (1.0f - lambda) * uniform;
}

using Splits = std::array<float, k_max_layers + 1>;  // slice i lies between entries i and i + 1

}  // namespace gnomon
