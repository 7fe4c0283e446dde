// Light space perspective shadow maps (Wimmer, Scherzer and Purgathofer 2004): one map, warped along the view in the light's
// plane, so that texels grow with the distance from the viewer. Parallel light stays parallel, unlike in perspective shadow
// maps. Cost: one depth pass. Fails: helps only where light and view cross at a large angle; edges move and swim when the
// viewer turns; texels far away are larger than without the warp.
#include "shadow/map/warp.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One map, warped so that texels near the viewer are smaller than those far away.\n"
    "Wimmer, Scherzer, Purgathofer 2004. The warp is a perspective in the light's plane, along the view, whose apex lies where "
    "the\n"
    "perspective error is the same at both ends of the view; it fades to a uniform map as the light turns along the view, "
    "where it\n"
    "cannot help. One depth pass. Edges swim when the viewer turns, and shadows far away are coarser than in single.";

class LightSpacePerspective : public WarpedProjection<Params> {
  using WarpedProjection::WarpedProjection;
  float apex_distance(const WarpFit& fit) const override {
    return light_space_perspective_distance(fit, params_.nearest, params_.strength);
  }
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {
      GNOMON_ID_TEXT,
      k_manual,
      param_table_storage(),
      {LightKind::directional, LightKind::projector},
      [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<LightSpacePerspective>(params); }};
}

}  // namespace gnomon
