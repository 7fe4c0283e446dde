// Why a technique gives the answer that it gives at a point: from what it read there and what is right.
#pragma once

#include <optional>
#include <string>

#include "shadow/map/glsl/explain_data.glsl"

namespace gnomon {

struct PickFacts {
  PickRecord record = {};
  bool has_map = false;
  bool compares_depth = true;  // the filter reads the depth map itself; else what was made of it (moments, exponentials)
  bool stores_objects = false;
  bool front_face_culling = false;  // bias.front_face_culling
  float unsettled = 0.0f;           // ShadowMapView
  std::optional<float> hard, area;  // reference: the ray to the light's centre; the light's real size. Unknown: not yet traced
};

enum class Cause {
  none,  // nothing is wrong, or nothing is known of what is right
  sky,
  no_receiver,
  outside_map,
  last_split,  // behind the last layer
  acne,
  peter_panning,  // the biases move the receiver before its caster
  light_bleeding,
  resolution,     // the texel is larger than what it should tell apart
  missed_caster,  // no texel holds the caster
  filter_width,
  penumbra,  // the light's size, which the technique does not see or takes for another
  history,   // the map is partly that of earlier frames
  unknown,
};

struct Reason {
  Cause cause = Cause::none;
  std::string text;
};

Reason reason_of(const PickFacts& facts);

// What the filter meets within its reach in one layer.
struct KernelContent {
  int texels = 0;
  int occluding = 0;             // nearer to the light than the biased receiver
  int own = 0;                   // of those, on the receiver's own plane
  int hidden_by_bias = 0;        // nearer than the receiver, but not than the biased one
  bool centre_occluded = false;  // the texel that holds the point, by another surface
  float occluder_gap_m = 0.0f;   // the receiver's plane to the farthest of the other surfaces that occlude
  float hidden_gap_m = 0.0f;     // ... to the farthest of what the bias hides
  float deviation_m = 0.0f;      // standard deviation of the stored depths
  float plane_span_m = 0.0f;     // how far the receiver's plane rises from the point to the kernel's edge, along the light
  float bias_m = 0.0f;           // how far toward the light the biases move the receiver
};
// `reach`: texels from the point, at most half of k_pick_side.
KernelContent kernel_content(const PickedLayer& layer, float reach);

// "3.2 cm".
std::string length_text(float metres);

}  // namespace gnomon
