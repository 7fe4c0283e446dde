// Percentage-closer soft shadows (Fernando 2005, "Percentage-closer soft shadows", SIGGRAPH sketches): the mean depth of
// blockers around the point says how wide the penumbra is, and a percentage-closer filter that wide makes it. Cost: search_taps
// texel reads, then taps comparisons of 2x2 texels, all over a disc that grows with the light. Fails: one mean stands for all
// blockers, so penumbrae of overlapping casters at different heights are wrong, and the map sees casters from the light's
// centre only; few taps over a wide disc are noise (rotate) or bands.
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Soft shadows whose penumbra widens with the distance to the caster.\n"
    "Fernando 2005. Texels nearer to the light than the receiver are looked for over the disc from which a blocker could hide "
    "part of\n"
    "the light; their mean depth gives the penumbra's width by similar triangles from the light's real size (angular diameter "
    "of a\n"
    "sun, radius of a lamp), and that many texels are filtered. Two refinements: pcss.cone leaves out texels that the search "
    "meets\n"
    "but that hide nothing of the light, among them the receiver itself; pcss.rise keeps a wide filter from taking the "
    "receiver's own\n"
    "unevenness for a caster. A light without size gets a sharp filter of pcss.min_radius. One mean stands for all blockers:\n"
    "overlapping penumbrae of casters at different heights are wrong. pcss.max_radius limits how far the taps are spread; "
    "beyond it\n"
    "shadows are too sharp. Few taps over a wide disc give noise (pcss.rotate) or bands.";

class Pcss : public Filter {
 public:
  explicit Pcss(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  float reach() const override { return params_.max_radius + 2.0f; }

 private:
  Params params_;
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Pcss>(params); }};
}

}  // namespace gnomon
