// Percentage-closer filtering (Reeves, Salesin and Cook 1987): the mean of many comparisons.
// Cost: size^2 hardware comparisons. Fails: grey steps when taps are few, a fixed blur where the true penumbra grows with distance,
// and more acne the wider the kernel, because taps far from the receiver compare with its depth: hence the receiver plane.
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "The mean of size x size comparisons around the point.\n"
    "Reeves, Salesin and Cook 1987. Each comparison is the hardware's bilinear 2x2 (pcf.bilinear) or a single texel;\n"
    "pcf.size=1 without bilinear is the hard filter. Cost grows with size^2. The blur is as wide everywhere, unlike a true\n"
    "penumbra, and a wide kernel needs the receiver plane (bias.receiver_plane) or more bias.";

class Pcf : public Filter {
 public:
  void set(const ParamBlock&) override {}
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock&) -> std::unique_ptr<Filter> { return std::make_unique<Pcf>(); }};
}

}  // namespace gnomon
