// From facts to a sentence.
#include "lab/explain/reason.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/glsl/light_sampling.glsl"

namespace gnomon {
namespace {

// Answers that differ by less are the same: a reference of some hundred rays knows no more.
constexpr float k_tolerance = 0.05f;
// A map whose older share is less than this tells of now.
constexpr float k_settled = 0.05f;

struct Context {
  const PickFacts& facts;
  const PickedLayer& layer;
  KernelContent near;  // within the filter's stated reach
  KernelContent wide;  // within all that was read
};

std::string texels(float length_m, float texel_m) {
  return fmt::format("{:.2g} texels ({})", length_m / texel_m, length_text(length_m));
}

std::string texel_text(const PickedLayer& layer) {
  std::string text = fmt::format("a texel is {} wide", length_text(layer.texel_m));
  if (layer.pixels_per_texel > 0.0f) text += fmt::format(" and spans {:.2g} pixels", layer.pixels_per_texel);
  return text;
}

std::string kernel_text(const Context& c) {
  const float radius = c.facts.record.radius;
  return fmt::format("the kernel reaches {:.2g} texels ({}) from the point", radius, length_text(radius * c.layer.texel_m));
}

Reason history(const Context& c) {
  return {Cause::history,
          fmt::format("{:.0f} % of the map is from before its last change (temporal.history)", 100.0f * c.facts.unsettled)};
}

Reason acne(const Context& c) {
  const float texel_m = c.layer.texel_m;
  const std::string who =
      fmt::format("acne: {} of the {} texels that occlude hold the receiver's own surface", c.near.own, c.near.occluding);
  if (c.layer.follows_plane == 0) {
    return {Cause::acne, fmt::format("{}; its plane spans {} within the kernel, the bias covers {}", who,
                                     texels(c.near.plane_span_m, texel_m), texels(c.near.bias_m, texel_m))};
  }
  return {Cause::acne, fmt::format("{}, which leaves its plane within the kernel; the plane is followed, the bias covers {}",
                                   who, texels(c.near.bias_m, texel_m))};
}

Reason false_shadow(const Context& c) {
  if (c.facts.unsettled > k_settled) return history(c);
  if (c.near.own > 0 && 2 * c.near.own >= c.near.occluding) return acne(c);
  if (c.near.centre_occluded) {
    return {Cause::resolution,
            fmt::format("resolution: {}; at its centre a caster stands {} nearer to the light, at the point none does",
                        texel_text(c.layer), length_text(c.near.occluder_gap_m))};
  }
  if (c.near.occluding > 0) {
    return {Cause::filter_width, fmt::format("filter width: {} of {} texels are behind a caster; {}", c.near.occluding,
                                             c.near.texels, kernel_text(c))};
  }
  if (c.facts.stores_objects && c.layer.object != 0 && c.layer.object != c.facts.record.object + 1) {
    return {Cause::resolution, fmt::format("resolution: {}, and it stores another object", texel_text(c.layer))};
  }
  if (c.wide.occluding > 0) {
    return {Cause::penumbra,
            fmt::format(
                "penumbra: the nearest caster lies beyond the filter's least radius of {:.2g} texels; it takes the light for "
                "larger, or the caster for farther away, than they are",
                c.facts.record.radius)};
  }
  return {Cause::unknown, "no texel nearby is nearer to the light than the point"};
}

Reason light_bleeding(const Context& c) {
  return {Cause::light_bleeding, fmt::format("light bleeding: {} of {} texels are behind a caster, up to {} nearer to the "
                                             "light, but the depths under the filter differ by {} "
                                             "(standard deviation): its bound lets {:.2f} through",
                                             c.near.occluding, c.near.texels, length_text(c.near.occluder_gap_m),
                                             length_text(c.near.deviation_m), c.facts.record.answer)};
}

Reason false_light(const Context& c) {
  if (c.facts.unsettled > k_settled) return history(c);
  const int lit = c.near.texels - c.near.occluding;
  const float lit_share = static_cast<float>(lit) / static_cast<float>(std::max(c.near.texels, 1));
  if (!c.facts.compares_depth && c.near.occluding > 0 && c.facts.record.answer > 1.25f * lit_share + 0.5f * k_tolerance)
    return light_bleeding(c);
  // Most of what lets light through would not without the bias.
  if (c.near.hidden_by_bias > 0 && 2 * c.near.hidden_by_bias >= lit && c.near.hidden_gap_m <= 1.5f * c.near.bias_m) {
    return {Cause::peter_panning,
            fmt::format("peter-panning: the bias moves the receiver by {}, more than the gap of {} to its caster",
                        texels(c.near.bias_m, c.layer.texel_m), length_text(c.near.hidden_gap_m))};
  }
  if (c.near.occluding > 0 || c.wide.centre_occluded) {
    return {Cause::filter_width, fmt::format("filter width: {} of {} texels are behind a caster; {}", c.near.occluding,
                                             c.near.texels, kernel_text(c))};
  }
  if (c.wide.occluding > 0) {
    return {Cause::resolution,
            fmt::format(
                "resolution: {}, and the caster's edge in the map is that far off; {} texels near the point hold the caster",
                texel_text(c.layer), c.wide.occluding)};
  }
  return {Cause::missed_caster,
          fmt::format("no texel nearby holds the caster: it is thinner than a texel, or not drawn{}; {}",
                      c.facts.front_face_culling ? " (front faces are culled)" : "", texel_text(c.layer))};
}

Reason outside(const PickRecord& record) {
  if (record.last_split > 0.0f && record.last_split < 1e30f && record.view_depth > record.last_split) {
    return {Cause::last_split, fmt::format("behind the last split, which is at {}: the point is {} away, and lit by definition",
                                           length_text(record.last_split), length_text(record.view_depth))};
  }
  return {Cause::outside_map, "outside every layer of the map: lit by definition"};
}

Context context_of(const PickFacts& facts) {
  const PickRecord& record = facts.record;
  const PickedLayer& layer = record.layers[record.count > 1 && record.layers[1].weight > record.layers[0].weight ? 1 : 0];
  return {facts, layer, kernel_content(layer, record.radius), kernel_content(layer, 0.5f * static_cast<float>(k_pick_side))};
}

std::string shadow_text(const PickFacts& facts) {
  if (!facts.has_map || facts.record.count == 0) return {};
  const Context c = context_of(facts);
  if (c.near.occluding == c.near.own) return {};
  return fmt::format("; the map holds a caster {} nearer to the light", length_text(c.near.occluder_gap_m));
}

Reason correct(const PickFacts& facts, const char* by) {
  const float answer = facts.record.answer;
  if (answer >= 1.0f - k_tolerance) return {Cause::none, fmt::format("lit, and so says {}", by)};
  if (answer <= k_tolerance) return {Cause::none, fmt::format("in shadow, and so says {}{}", by, shadow_text(facts))};
  return {Cause::none, fmt::format("{:.2f} of the light arrives, and so says {}", answer, by)};
}

Reason wrong(const PickFacts& facts, float target) {
  const PickRecord& record = facts.record;
  const float error = record.answer - target;
  Reason reason;
  if (!facts.has_map) {
    reason = {Cause::penumbra, "the technique does not see the light's size"};
  } else if (record.count == 0) {
    reason = outside(record);
  } else {
    const Context c = context_of(facts);
    reason = error < 0.0f ? false_shadow(c) : false_light(c);
  }
  reason.text = fmt::format("false {} of {:.2f}: {}", error < 0.0f ? "shadow" : "light", std::abs(error), reason.text);
  return reason;
}

}  // namespace

std::string length_text(float metres) {
  const float size = std::abs(metres);
  if (size >= 1.0f) return fmt::format("{:.2f} m", metres);
  if (size >= 0.01f) return fmt::format("{:.1f} cm", 100.0f * metres);
  return fmt::format("{:.2g} mm", 1000.0f * metres);
}

Reason reason_of(const PickFacts& facts) {
  const PickRecord& record = facts.record;
  if (record.seen == 0) return {Cause::sky, "the sky: no surface receives light here"};
  if (record.receives == 0) {
    if (record.facing <= k_grazing_cosine) {
      return {Cause::no_receiver,
              fmt::format("faces away from the light (cosine {:.2f}): no receiver, dark by definition", record.facing)};
    }
    return {Cause::no_receiver, "beyond the light's range, cone or beam: no receiver, dark by definition"};
  }
  if (!facts.hard) {
    if (facts.has_map && record.count == 0) return outside(record);
    return {Cause::none, fmt::format("{:.2f} of the light arrives; what is right is not yet known", record.answer)};
  }
  const float hard_error = std::abs(record.answer - *facts.hard);
  if (hard_error <= k_tolerance) return correct(facts, "the ray to the light's centre");
  if (!facts.area) return wrong(facts, *facts.hard);
  const float area_error = std::abs(record.answer - *facts.area);
  if (area_error <= k_tolerance) return correct(facts, "the light's real size");
  return wrong(facts, area_error < hard_error ? *facts.area : *facts.hard);
}

}  // namespace gnomon
