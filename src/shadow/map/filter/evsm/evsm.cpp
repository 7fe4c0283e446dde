// Exponential variance shadow maps (Lauritzen and McCool 2008, "Layered Variance Shadow Maps"): moments of exponentially warped
// depth. Cost: as vsm with twice the channels. Fails: less bleeding than vsm, the less the larger the exponents, which floats
// limit; with 16-bit floats the exponents are so small that much of it remains.
#include "shadow/map/moments/moment_filter.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Exponential variance shadow map: Chebyshev's bound on exp(c z), and on -exp(-c z).\n"
    "Lauritzen and McCool 2008. The positive warp squeezes the gap between occluders, so that a deeper shadow bleeds less than "
    "with\n"
    "vsm; the negative one (evsm.moments=four) removes what the first lets through close to a caster. Exponents are limited\n"
    "by what a float can square: 42 with 32 bits, 5.54 with 16. As both go to zero evsm becomes vsm.";

class Evsm : public MomentFilter<Params> {
  using MomentFilter::MomentFilter;
  MomentMapInfo describe() const override {
    constexpr VkFormat k_formats[2][2] = {{VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT},
                                          {VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT}};
    // The kernel computes both warps; an image of two channels takes the first.
    return {GNOMON_ID_TEXT, k_formats[params_.format][params_.moments]};
  }
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Evsm>(params); }};
}

}  // namespace gnomon
