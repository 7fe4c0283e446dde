// Moment shadow maps (Peters and Klein 2015; transform and biases: Peters, Muenstermann, Wetzstein and Klein 2017): four
// moments of depth. Cost: as vsm with twice the channels, at 16 bits each the same memory, and some forty operations more.
// Fails: three or more layers of casters in one kernel bleed a little.
#include "shadow/map/moments/moment_filter.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Moment shadow map: four moments of depth, and the sharpest bound that they allow (Hamburger).\n"
    "Peters and Klein 2015. Exact for any two depths in the kernel, where vsm is exact only for one caster before the\n"
    "receiver's own plane. 64 bits for a texel (msm.format=unorm16) suffice through an affine transform of the moments (Peters "
    "et\n"
    "al. 2017). Rounded moments may belong to no distribution: msm.moment_bias moves them inside, at the price of some light.";

class Msm : public MomentFilter<Params> {
  using MomentFilter::MomentFilter;
  MomentMapInfo describe() const override {
    return {GNOMON_ID_TEXT, params_.format == format_unorm16 ? VK_FORMAT_R16G16B16A16_UNORM : VK_FORMAT_R32G32B32A32_SFLOAT};
  }
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Msm>(params); }};
}

}  // namespace gnomon
