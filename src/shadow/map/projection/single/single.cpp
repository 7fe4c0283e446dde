// One map for the whole scene or the whole view (Williams 1978, "Casting curved shadows on curved surfaces").
// Idea: an orthographic view along the light, fitted in the light's plane to what can be seen and can cast.
// Cost: one depth pass. Fails: texels are as large near the viewer as far away, so shadows close to the camera show steps
// (perspective aliasing) unless the map is large or the scene small.
#include <algorithm>

#include "shadow/map/light_views.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One depth map of the whole scene, or of what the camera sees of it.\n"
    "Williams 1978. The light's orthographic view is fitted to the casters (fit=scene) or to the part of the view that holds\n"
    "geometry (fit=view); under a projector to its beam, under a spot light to its cone. One depth pass. Texels are equally "
    "large everywhere, so edges near the camera show steps: raise\n"
    "single.size, or use a cascaded projection.";

class Single : public Projection {
 public:
  explicit Single(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return 1; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    return {light.kind == LightKind::spot ? cone_view(frame, light) : parallel_view(frame, light)};
  }

 private:
  ShadowView parallel_view(const Frame& frame, const Light& light) const {
    const LightFrame light_frame(light.direction);
    const Box casters = light_frame.bounds(frame.scene().caster_bounds());
    Box fit = light_frame.bounds(frame.scene().bounds());
    const auto [near, far] = depth_range(casters, fit, light_start(light_frame, light));
    clip_to_beam(light_frame, light, fit);
    if (params_.fit == fit_view) clip_to_view(frame, light_frame, fit);
    // Nothing beyond the casters' own outline can be shadowed.
    fit.min.x = std::max(fit.min.x, casters.min.x), fit.max.x = std::min(fit.max.x, casters.max.x);
    fit.min.y = std::max(fit.min.y, casters.min.y), fit.max.y = std::min(fit.max.y, casters.max.y);
    return orthographic_view(light_frame, fit, near, far, map_size());
  }

  ShadowView cone_view(const Frame& frame, const Light& light) const {
    const auto [near, far] = distance_range(light.position, light.range, frame.scene().caster_bounds(), frame.scene().bounds());
    // A cone that is all but a half space would have no far texels left: 85 degrees is the most a plane can hold.
    const float half_angle = std::min(light.outer_cone * 1.01f, 85.0f * k_pi / 180.0f);
    return perspective_view(light.position, LightFrame(light.direction).world_from_light, half_angle, near, far, map_size());
  }

  // Narrows x and y to the light-space outline of the visible part of the scene.
  static void clip_to_view(const Frame& frame, const LightFrame& light_frame, Box& fit) {
    Box view;
    const auto [near, far] = frame.visible_range();
    for (const vec3& corner : slice_corners(frame.camera(), near, far)) view.add(light_frame.to_light(corner));
    fit.min.x = std::max(fit.min.x, view.min.x), fit.max.x = std::min(fit.max.x, view.max.x);
    fit.min.y = std::max(fit.min.y, view.min.y), fit.max.y = std::min(fit.max.y, view.max.y);
  }

  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::directional, LightKind::spot, LightKind::projector},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Single>(params); }};
}

}  // namespace gnomon
