// Percentage-closer filtering (Reeves, Salesin and Cook 1987): the mean of many comparisons.
// Cost: grid size^2 reads of 2x2 texels, optimised ((size + 1) / 2)^2, discs one for each tap. Fails: grey steps when taps are
// few, a fixed blur where the true penumbra grows with distance, and a plane that the surface leaves within a wide kernel.
#include <algorithm>

#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "The mean of many comparisons around the point.\n"
    "Reeves, Salesin and Cook 1987. Each comparison is of 2x2 texels with bilinear weights (pcf.bilinear) or of a single "
    "texel, and\n"
    "each texel is compared with the receiver's plane at its own place (bias.receiver_plane). pcf.kernel: grid makes size x "
    "size\n"
    "comparisons; optimised gives the same result from ((size + 1) / 2)^2 reads, which are the sampler's own comparisons where "
    "there\n"
    "is no plane to follow; poisson and vogel spread pcf.taps over a disc of pcf.radius, turned at each pixel (pcf.rotate), "
    "which\n"
    "trades grey steps for noise. pcf.size=1 without bilinear is the hard filter. The blur is as wide everywhere, unlike a "
    "true\n"
    "penumbra (pcss). A wide kernel over a curved or small receiver follows a plane that the surface has left: see "
    "bias.plane_limit.";

class Pcf : public Filter {
 public:
  explicit Pcf(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  float reach() const override { return std::max(0.5f * static_cast<float>(params_.size), params_.radius) + 2.0f; }

 private:
  Params params_;
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Pcf>(params); }};
}

}  // namespace gnomon
