// Variance shadow maps (Donnelly and Lauritzen 2006): the map stores mean and mean square of depth, so that it can be blurred,
// mipmapped and sampled like a texture. Cost: one conversion pass and one texture read. Fails: where two casters overlap along a ray
// the variance is large and light bleeds into the deeper shadow.
#include "shadow/map/moment_map.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Variance shadow map: mean and mean square of depth, blurred, bounded by Chebyshev's inequality.\n"
    "Donnelly and Lauritzen 2006. One conversion and blur in compute, then a single filtered read, however wide the blur. The bound\n"
    "is exact for one flat caster over one flat receiver; where casters at different depths overlap, light bleeds into the\n"
    "deeper shadow: raise vsm.bleeding, or use evsm or msm. vsm.samples averages several samples of each texel.";

class Vsm : public Filter {
 public:
  explicit Vsm(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  float reach() const override { return static_cast<float>(params_.blur) + (params_.mips ? 64.0f : 3.0f); }
  uint32_t depth_samples() const override { return 1u << params_.samples; }
  void prepare(Device& device, const MapInfo& info) override {
    moments_ = MomentMap(device, info, {GNOMON_ID_TEXT, VK_FORMAT_R32G32_SFLOAT, 2, depth_samples(), params_.mips != 0});
  }
  void record(Recorder& recorder, const DrawnMap& map) override { moments_.record(recorder, map, static_cast<uint32_t>(params_.blur)); }
  const Image& map(const DrawnMap&) const override { return moments_.image(); }

 private:
  Params params_;
  MomentMap moments_;
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Vsm>(params); }};
}

}  // namespace gnomon
