// The truth of one view: reference masks of every light, hard and with the light's real size, checked before they are believed.
#pragma once

#include <optional>

#include "lab/view/session.h"

namespace gnomon {

struct LightReference {
  ReferenceResult hard;
  std::optional<ReferenceResult> area;  // where the light has a size and the settings ask for it
};

struct ReferenceSet {
  std::string kind;  // "embree" or "pipeline"
  int samples = 0;   // of area
  std::vector<LightReference> lights;
};

// Traces. The surface buffer must be drawn. Throws Error when the acceleration structure does not hold the triangles that the
// rasteriser draws as casters: such a reference would flatter or slander every technique.
ReferenceSet make_references(Session& session);

// Triangles that the rasteriser assembles for all casters, read from the GPU's pipeline statistics (from the scene's list where
// the device has none).
size_t rasterised_caster_triangles(Session& session);

}  // namespace gnomon
