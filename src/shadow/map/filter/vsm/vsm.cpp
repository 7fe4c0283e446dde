// Variance shadow maps (Donnelly and Lauritzen 2006): the map stores mean and mean square of depth, so that it can be blurred,
// mipmapped and sampled like a texture. Cost: one conversion pass and one texture read. Fails: where two casters overlap along
// a ray the variance is large and light bleeds into the deeper shadow.
#include "shadow/map/moments/moment_filter.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Variance shadow map: mean and mean square of depth, blurred, bounded by Chebyshev's inequality.\n"
    "Donnelly and Lauritzen 2006. One conversion and blur in compute, then a single filtered read, however wide the blur. The "
    "bound\n"
    "is exact for one flat caster over one flat receiver; where casters at different depths overlap, light bleeds into the\n"
    "deeper shadow: raise vsm.bleeding, or use evsm or msm. vsm.samples averages several samples of each texel. vsm.mips "
    "answers for\n"
    "the whole pixel, and so errs more where the reference is one ray through its middle (courtyard, 320x240: area mae 0.044, "
    "without\n"
    "0.031) and less against the mean of 16 rays a pixel (courtyard, 160x120: mae 0.037, without 0.059).";

class Vsm : public MomentFilter<Params> {
  using MomentFilter::MomentFilter;
  MomentMapInfo describe() const override { return {GNOMON_ID_TEXT, VK_FORMAT_R32G32_SFLOAT}; }
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Vsm>(params); }};
}

}  // namespace gnomon
