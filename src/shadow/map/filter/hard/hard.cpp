// One comparison with the texel that holds the point (Williams 1978).
// Cost: one texel read. Fails: edges are stair-cases of texels; acne without bias, peter-panning with too much.
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One comparison with the texel that holds the point.\n"
    "Williams 1978: lit where the stored depth is not nearer than the receiver's. One texel read. Edges are stair-cases of\n"
    "texels; too little bias gives acne, too much detaches shadows from their casters (peter-panning).";

class Hard : public Filter {
 public:
  void set(const ParamBlock&) override {}
  float reach() const override { return 1.0f; }
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock&) -> std::unique_ptr<Filter> { return std::make_unique<Hard>(); }};
}

}  // namespace gnomon
