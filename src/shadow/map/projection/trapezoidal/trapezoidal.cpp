// Trapezoidal shadow maps (Martin and Tan 2004, "Anti-aliasing and continuity with trapezoidal shadow maps"): one map, whose trapezoid
// around the visible part is stretched to the square so that the part near the viewer gets a chosen share of it.
// Cost: one depth pass. Fails: as light_space_perspective; what lies beyond the focus shares the rest of the map. The original warps
// depth as well and repairs it in a fragment shader; here depth stays along the light.
#include "shadow/map/warp.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One map, stretched so that the nearest part of the view gets most of it.\n"
    "Martin, Tan 2004. A trapezoid around what is visible, seen from the light, becomes the square; its apex is placed so that the\n"
    "nearest trapezoidal.focus of the view gets trapezoidal.share (80 %) of the map. It fades to a uniform map as the light turns along\n"
    "the view. One depth pass. What lies beyond the focus shares the rest: edges there are coarser than in single.";

class Trapezoidal : public Projection {
 public:
  explicit Trapezoidal(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return 1; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    const auto [near, far] = frame.visible_range();
    const WarpFit fit = warp_fit(frame.camera(), light, frame.scene().caster_bounds(), frame.scene().bounds(), near, far);
    return {warped_view(fit, trapezoidal_distance(fit, params_.focus, params_.share), map_size(), params_.border)};
  }

 private:
  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), {LightKind::directional, LightKind::projector},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Trapezoidal>(params); }};
}

}  // namespace gnomon
