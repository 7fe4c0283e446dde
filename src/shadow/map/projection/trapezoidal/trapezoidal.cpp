// Trapezoidal shadow maps (Martin and Tan 2004, "Anti-aliasing and continuity with trapezoidal shadow maps"): one map, whose
// trapezoid around the visible part is stretched to the square so that the part near the viewer gets a chosen share of it.
// Cost: one depth pass. Fails: as light_space_perspective; what lies beyond the focus shares the rest of the map. The original
// warps depth as well and repairs it in a fragment shader; here depth stays along the light.
#include "shadow/map/warp.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One map, stretched so that the nearest part of the view gets most of it.\n"
    "Martin, Tan 2004. A trapezoid around what is visible, seen from the light, becomes the square; its apex is placed so that "
    "the\n"
    "nearest trapezoidal.focus of the view gets trapezoidal.share (80 %) of the map. It fades to a uniform map as the light "
    "turns along\n"
    "the view. One depth pass. What lies beyond the focus shares the rest: edges there are coarser than in single.";

class Trapezoidal : public WarpedProjection<Params> {
  using WarpedProjection::WarpedProjection;
  float apex_distance(const WarpFit& fit) const override { return trapezoidal_distance(fit, params_.focus, params_.share); }
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::directional, LightKind::projector},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Trapezoidal>(params); }};
}

}  // namespace gnomon
