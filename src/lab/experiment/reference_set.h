// The truth of one view: reference masks of every light, hard and with the light's real size, checked before they are believed.
#pragma once

#include <optional>

#include "lab/view/session.h"
#include "reference/cpu/pixel_visibility.h"

namespace gnomon {

// What "right" means (docs/measuring.md): one ray from the pixel's centre to the light's; rays over the light from there; or
// the mean over points within the pixel, of rays over the light where it has a size.
enum class Truth { hard, area, pixel };
inline constexpr Truth k_truths[] = {Truth::pixel, Truth::area, Truth::hard};  // the first is what tables sort by
const char* truth_name(Truth truth);
// Throws Error (usage) for another name.
Truth truth_named(std::string_view name);

struct LightReference {
  ReferenceResult hard;
  std::optional<ReferenceResult> area;   // where the light has a size and the settings ask for it
  std::optional<PixelVisibility> pixel;  // where the settings ask for it

  const ReferenceResult* find(Truth truth) const;  // nullptr where there is none
};

struct ReferenceSet {
  std::string kind;  // "embree" or "pipeline"
  int samples = 0;   // of area
  int pixel_samples = 0, rays_per_pixel_sample = 0;
  std::vector<LightReference> lights;
};

// Traces; all that the settings ask for, or (hard and) one. The surface buffer must be drawn. Throws Error when the
// acceleration structure does not hold the triangles that the rasteriser draws as casters: such a reference would flatter or
// slander every technique.
ReferenceSet make_references(Session& session, std::optional<Truth> only = std::nullopt);

// Triangles that the rasteriser assembles for all casters, read from the GPU's pipeline statistics (from the scene's list where
// the device has none).
size_t rasterised_caster_triangles(Session& session);

}  // namespace gnomon
