// Exponential shadow maps (Annen et al. 2008; Salvi 2008): the comparison of two depths becomes the product of two
// exponentials, one of which is stored and blurred. Cost: one conversion pass over one channel and one texture read. Fails:
// near contact, where caster and receiver are nearer than some 1/c, and where the kernel sees something beyond the receiver.
#include "shadow/map/moments/moment_filter.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Exponential shadow map: lit = exp(-c d) times the blurred exp(c z), one channel.\n"
    "Annen, Mertens, Seidel, Flerackers and Kautz 2008. No variance, so no bleeding where two shadows overlap; instead a "
    "shadow\n"
    "fades in over 1/c behind its caster, and light leaks where the kernel reaches a surface behind the receiver. esm.c "
    "counts\n"
    "per range of the map's depths, or per metre (esm.unit): then the fade is as long in a scene of any size.\n"
    "esm.space=log stores c z (Lauritzen 2008): any c is safe, reads average the exponentials of four texels themselves; "
    "mipmaps\n"
    "and anisotropy (esm.mips) interpolate logarithms there, which darkens edges. esm.space=exponential stores exp(c z), for c "
    "up\n"
    "to 160 per range. As published, c = 80 per range (esm.unit=range, esm.c=80): pre-filtered ESM with esm.blur=0,\n"
    "esm.prefilter=true; blurred ESM with esm.blur=2 (5 x 5). The default, 10 per metre, errs less in courtyard.";

class Esm : public MomentFilter<Params> {
  using MomentFilter::MomentFilter;
  bool prefilter() const override { return params_.prefilter != 0; }
  MomentMapInfo describe() const override {
    return {.filter = GNOMON_ID_TEXT, .format = VK_FORMAT_R32_SFLOAT, .logarithms = params_.space == space_log};
  }
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Esm>(params); }};
}

}  // namespace gnomon
