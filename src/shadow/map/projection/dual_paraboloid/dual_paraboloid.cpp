// Two paraboloid views around a point light, one for each half of all directions (Brabec, Annen and Seidel 2002, "Shadow
// mapping for hemispherical and omnidirectional light sources"). A point at distance d with axis component z falls on (x, y) /
// (d + z): a disc whose texels see solid angles that differ by four at most, rim to middle; depth is the distance. Cost: two
// depth passes instead of a cube's six. Fails: the map of a straight edge is an arc, which a rasteriser draws as its chord:
// with triangles=bent, triangles that are large as seen from the light cast displaced shadows and shadow themselves.
// triangles=exact draws the box around each triangle's true outline and intersects every texel's ray (after Gascuel et al.
// 2008, "Fast non-linear projections using graphics hardware"): right for all triangles, for more fragments and without early
// depth tests.
#include <algorithm>

#include "shadow/map/light_views.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Two maps around a point light, each of half of all directions on a disc.\n"
    "Brabec, Annen, Seidel 2002. Two depth passes instead of six. A straight edge is an arc on the disc; rasterisers draw its "
    "chord.\n"
    "triangles=bent does so: coarse triangles cast displaced shadows, and shadow themselves where they sag. triangles=exact "
    "(Gascuel\n"
    "et al. 2008) intersects each texel's ray with the triangle, in the box around its true outline, and costs fragments "
    "instead.\n"
    "Texels are twice as large, as angles, in the middle of a half as at its rim, and the corners of the square hold "
    "directions that only the other map is asked for.";

class DualParaboloid : public Projection {
 public:
  explicit DualParaboloid(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return 2; }
  bool exact_paraboloid() const override { return params_.triangles == triangles_exact; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    const auto [near, far] = distance_range(light.position, light.range, frame.scene().caster_bounds(), frame.scene().bounds());
    const vec3 axis = axis_of(frame, light);
    return {half_view(light.position, axis, near, far), half_view(light.position, -axis, near, far)};
  }

 private:
  vec3 axis_of(const Frame& frame, const Light& light) const {
    const vec3 down(0, -1, 0);
    if (params_.axis == axis_down) return down;
    if (params_.axis == axis_view) return frame.camera().forward_ws;
    const vec3 to_middle = frame.scene().bounds().centre() - light.position;
    const float distance = glm::length(to_middle);
    return distance > 1e-3f * frame.scene().bounds().radius() ? to_middle / distance : down;
  }

  ShadowView half_view(const vec3& position, const vec3& axis, float near, float far) const {
    const mat3 axes = LightFrame(axis).world_from_light;
    const float size = static_cast<float>(params_.size);
    ShadowView view = {};
    view.raster.clip_from_world = mat4(glm::transpose(axes));
    view.raster.clip_from_world[3] = vec4(-(glm::transpose(axes) * position), 1.0f);
    view.world_from_clip = glm::inverse(view.raster.clip_from_world);
    const float rim = 1.0f - std::min(2.0f * params_.border / size, 0.5f);
    view.raster.clip_from_world[3][3] = rim;
    view.raster.kind = k_view_paraboloid;
    view.raster.near_m = view.depth_near_m = near;
    view.raster.far_m = far;
    view.raster.in_use = 1;
    view.raster.texel_clip = 2.0f / size;
    view.linear_numerator = vec4(0, 0, 1, 0);
    view.linear_denominator = vec4(0, 0, 0, 1);
    view.origin_ws = position;
    view.depth_range_m = far - near;
    // On the axis an angle is twice its place on the disc, and a texel 2 / size of the square from -1 to 1.
    view.texel_m = 4.0f / (size * rim);
    view.size = size;
    view.border = params_.border;
    view.interval_m = vec2(0.0f, 3.0e38f);
    return view;
  }

  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::point},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<DualParaboloid>(params); }};
}

}  // namespace gnomon
