// One map for the whole scene or the whole view (Williams 1978, "Casting curved shadows on curved surfaces").
// Idea: an orthographic view along the light, fitted in the light's plane to what can be seen and can cast.
// Cost: one depth pass. Fails: texels are as large near the viewer as far away, so shadows close to the camera show steps
// (perspective aliasing) unless the map is large or the scene small.
#include "base/error.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One depth map of the whole scene, or of what the camera sees of it.\n"
    "Williams 1978. The light's orthographic view is fitted to the casters (fit=scene) or to the part of the view that holds\n"
    "geometry (fit=view). One depth pass. Texels are equally large everywhere, so edges near the camera show steps: raise\n"
    "single.size, or use a cascaded projection.";

// Light space: x and y across the light, z along it (metres).
struct LightFrame {
  mat3 world_from_light;
  explicit LightFrame(const vec3& direction) {
    vec3 x, y;
    orthonormal_basis(direction, x, y);
    world_from_light = mat3(x, y, direction);
  }
  vec3 to_light(const vec3& p) const { return glm::transpose(world_from_light) * p; }
  Box bounds(const Box& box) const {
    Box result;
    for (int i = 0; i < 8; ++i) result.add(to_light(box.corner(i)));
    return result;
  }
};

class Single : public Projection {
 public:
  explicit Single(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return 1; }
  bool depth_clamp() const override { return false; }  // the view begins before the first caster

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    const LightFrame light_frame(light.direction);
    const Box casters = light_frame.bounds(frame.scene().caster_bounds());
    Box fit = light_frame.bounds(frame.scene().bounds());
    const float farthest = fit.max.z;
    if (params_.fit == fit_view) clip_to_view(frame, light_frame, fit);
    // Nothing beyond the casters' own outline can be shadowed.
    fit.min.x = std::max(fit.min.x, casters.min.x), fit.max.x = std::min(fit.max.x, casters.max.x);
    fit.min.y = std::max(fit.min.y, casters.min.y), fit.max.y = std::min(fit.max.y, casters.max.y);
    // Depth from the first caster to the last receiver, with a margin so that neither lies on a plane of the box.
    const float margin = 1e-3f * std::max(farthest - casters.min.z, 1e-3f);
    return {orthographic_view(light_frame, fit, casters.min.z - margin, farthest + margin)};
  }

 private:
  // Narrows x and y to the light-space outline of the visible part of the scene.
  static void clip_to_view(const Frame& frame, const LightFrame& light_frame, Box& fit) {
    Box view;
    const auto [near, far] = frame.visible_range();
    for (const vec3& corner : slice_corners(frame.camera(), near, far)) view.add(light_frame.to_light(corner));
    fit.min.x = std::max(fit.min.x, view.min.x), fit.max.x = std::min(fit.max.x, view.max.x);
    fit.min.y = std::max(fit.min.y, view.min.y), fit.max.y = std::min(fit.max.y, view.max.y);
  }

  ShadowView orthographic_view(const LightFrame& light_frame, const Box& fit, float near, float far) const {
    // A view that sees no caster keeps a small valid map; everything is then outside it and lit.
    const float width = std::max(fit.max.x - fit.min.x, 1e-3f), height = std::max(fit.max.y - fit.min.y, 1e-3f);
    const float depth = far - near;
    mat4 clip_from_light(0.0f);
    clip_from_light[0][0] = 2.0f / width;
    clip_from_light[1][1] = 2.0f / height;
    clip_from_light[2][2] = 1.0f / depth;
    clip_from_light[3] = vec4(-(2.0f * fit.min.x + width) / width, -(2.0f * fit.min.y + height) / height, -near / depth, 1.0f);
    ShadowView view;
    view.clip_from_world = clip_from_light * mat4(glm::transpose(light_frame.world_from_light));
    view.texel_m = std::max(width, height) / static_cast<float>(params_.size);
    view.depth_range_m = depth;
    view.size = static_cast<float>(params_.size);
    view.unused = 0.0f;
    return view;
  }

  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), {LightKind::directional},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Single>(params); }};
}

}  // namespace gnomon
