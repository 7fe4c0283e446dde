// The texels around a picked point, compared as a filter compares them.
#include <algorithm>
#include <cmath>

#include "lab/explain/reason.h"

namespace gnomon {
namespace {

// A stored depth that lies this near to the receiver's plane is the receiver's own, in texels: what is nearer no map can tell
// apart.
constexpr float k_own_texels = 0.5f;
// A caster must stand out of the receiver by so much to be one.
constexpr float k_least_gap_texels = 0.02f;

float linear_of(const PickedLayer& layer, const vec2& uv, float depth) {
  const vec4 ndc(uv * 2.0f - 1.0f, depth, 1.0f);
  return glm::dot(layer.linear_numerator, ndc) / glm::dot(layer.linear_denominator, ndc);
}

}  // namespace

KernelContent kernel_content(const PickedLayer& layer, float reach) {
  KernelContent content;
  const int side = static_cast<int>(k_pick_side), middle = side / 2;
  reach = std::clamp(reach, 0.5f, static_cast<float>(middle));
  const float range_m = layer.depth_range_m;
  content.bias_m = layer.bias_linear * range_m;
  const vec2 rise_m = glm::abs(layer.plane_linear_gradient) * (range_m / layer.size);  // for each texel
  content.plane_span_m = reach * (rise_m.x + rise_m.y);
  double sum = 0.0, squares = 0.0;
  int stored_count = 0;
  for (int i = 0; i < side * side; ++i) {
    const float stored = layer.depths[i];
    const vec2 texel(layer.texel_x + i % side - middle, layer.texel_y + i / side - middle);
    const vec2 uv = (texel + 0.5f) / layer.size, from_point = uv - layer.uv;
    const vec2 texels_away = glm::abs(from_point) * layer.size;
    // Half a texel's slack: of the texel that holds the point the centre is that far away.
    if (std::max(texels_away.x, texels_away.y) > reach + 1e-3f) continue;
    ++content.texels;
    if (stored == k_pick_outside) continue;
    const float move = std::clamp(glm::dot(layer.depth_gradient, from_point), -layer.plane_move, layer.plane_move);
    const bool occludes = stored < std::min(layer.depth + move, 1.0f);
    const float stored_linear = linear_of(layer, uv, stored);
    const float plane = layer.linear + layer.bias_linear + glm::dot(layer.plane_linear_gradient, from_point);
    const float gap_m = (plane - stored_linear) * range_m;
    const bool own = std::abs(gap_m) <= k_own_texels * layer.texel_m;
    sum += stored_linear, squares += static_cast<double>(stored_linear) * stored_linear;
    ++stored_count;
    if (occludes) {
      ++content.occluding;
      if (own) {
        ++content.own;
      } else {
        content.occluder_gap_m = std::max(content.occluder_gap_m, gap_m);
        content.centre_occluded |= i == middle * side + middle;
      }
    } else if (gap_m > k_least_gap_texels * layer.texel_m) {
      ++content.hidden_by_bias;
      content.hidden_gap_m = std::max(content.hidden_gap_m, gap_m);
    }
  }
  if (stored_count > 0) {
    const double mean = sum / stored_count;
    content.deviation_m = static_cast<float>(std::sqrt(std::max(squares / stored_count - mean * mean, 0.0))) * range_m;
  }
  return content;
}

}  // namespace gnomon
