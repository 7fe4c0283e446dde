// Cascaded shadow maps (Engel 2006; Zhang et al. 2006, parallel-split shadow maps; Dimitrov 2007): the view is cut into slices,
// each with a map of its own, so that texels grow with the distance from the viewer as pixels do.
#include <algorithm>
#include <cmath>

#include "scene/light_shape.h"
#include "shadow/map/light_views.h"
#include "shadow/map/splits.h"
#include "shadow/map/warp.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Several maps, each of a slice of the view, so that texels grow with distance as pixels do.\n"
    "Zhang et al. 2006; Dimitrov 2007. Slices end at uniform, logarithmic, mixed (cascaded.lambda) or given distances. "
    "fit=sphere with\n"
    "stabilise keeps every edge still while the viewer moves; fit=box wastes fewer texels and shimmers. One depth pass for "
    "each\n"
    "cascade, less what culling leaves out. Seams between cascades show where the filter's width jumps: raise cascaded.blend.\n"
    "selection=map takes the finest map that holds a point, which is often finer than that of its distance. adapt ends the "
    "last map where\n"
    "the last shadow can be seen (from boxes around groups of casters: a ground that casts counts), with as many maps as that "
    "needs.";

struct Sphere {
  vec3 centre;
  float radius;
};

// Of the view between two distances. From the numbers of the lens alone, so that it is the same bits wherever the camera
// stands.
Sphere slice_sphere(const CameraData& camera, float from, float to) {
  const float kx = glm::dot(camera.right_ws, camera.right_ws), ky = glm::dot(camera.up_ws, camera.up_ws);
  const float k2 = kx + ky;  // of the tangent from the axis to a corner; orthographic: of the metres
  if (camera.orthographic)
    return {camera.eye_ws + camera.forward_ws * (0.5f * (from + to)), std::sqrt(k2 + 0.25f * (to - from) * (to - from))};
  const float centre = std::min(0.5f * (from + to) * (1.0f + k2), to);
  const float radius = std::sqrt((to - centre) * (to - centre) + to * to * k2);
  return {camera.eye_ws + camera.forward_ws * centre, radius};
}

// The next number with eight significant bits: multiples of it are exact in floats, and it is the same however the last bits of
// the camera's axes fall.
float with_few_bits(float value) {
  int exponent = 0;
  const float mantissa = std::frexp(value * (1.0f + 1e-5f), &exponent);
  return std::ldexp(std::ceil(mantissa * 256.0f) / 256.0f, exponent);
}

class Cascaded : public Projection {
 public:
  explicit Cascaded(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return static_cast<uint32_t>(params_.count); }
  bool depth_clamp() const override { return params_.near == near_clamp; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    const LightFrame light_frame(light.direction);
    const Bounds bounds = {light_frame.bounds(frame.scene().bounds()), light_frame.bounds(frame.scene().caster_bounds()),
                           light_start(light_frame, light), light.kind == LightKind::projector};
    uint32_t count = layers();
    const Splits splits = find_splits(frame, light, count);
    std::vector<ShadowView> views;
    for (uint32_t i = 0; i < count; ++i) {
      ShadowView view = params_.warp != warp_none   ? warped_slice(frame, light, splits[i], splits[i + 1])
                        : params_.fit == fit_sphere ? sphere_view(frame, light_frame, bounds, splits[i], splits[i + 1])
                                                    : box_view(frame, light, light_frame, bounds, splits[i], splits[i + 1]);
      view.interval_m = vec2(i == 0 ? 0.0f : splits[i], splits[i + 1]);
      view.border = border();
      // As cascaded.glsl selects and blends.
      if (nested()) view.raster.served = (1.0f - 2.0f * border() / static_cast<float>(params_.size)) * (1.0f - params_.blend);
      views.push_back(view);
    }
    return views;
  }

 private:
  // A map that were all border would hold nothing.
  float border() const { return std::min(params_.border, 0.25f * static_cast<float>(params_.size)); }

  struct Bounds {
    Box scene, casters;  // in light space
    float start;         // light_start()
    bool projector;
  };

  // Distances between which the view is cut: {near, far}. Independent of where the camera stands within the scene, or in steps.
  std::pair<float, float> distance_range(const Frame& frame) const {
    const CameraData& camera = frame.camera();
    float far = std::min(camera.far_m, std::max(2.0f * frame.scene().bounds().radius(), frame.visible_range().second));
    if (params_.distance > 0.0f) far = params_.distance;
    far = std::max(far, camera.near_m * 1.01f);
    return {std::max(camera.near_m, far * 1e-5f), far};
  }

  // The farthest that a visible point can be shadowed: where the view meets what lies behind a group of casters, as the light
  // sees it. Zhang et al. ask for the farthest visible caster; one outside the view may cast into it, and so it is the shadow
  // that counts. Rounded up in steps of the square root of two, so that maps keep their size while the viewer moves a little.
  float needed_distance(const Frame& frame, const Light& light, float near, float far) const {
    const CameraData& camera = frame.camera();
    const Box& scene = frame.scene().bounds();
    const auto in_steps = [&](float farthest) {
      float distance = far;
      while (distance * 0.70710678f > farthest && distance * 0.70710678f > near * 2.0f) distance *= 0.70710678f;
      return distance;
    };
    // Penumbras and kernels reach beyond a caster's own outline.
    const float reach = light_shape(light, true).emitter_radius * 2.0f * scene.radius() +
                        border() * 2.0f * slice_sphere(camera, near, far).radius / static_cast<float>(params_.size);
    // Clipping the view takes some 20 us: bounds first, so that only groups that may be the farthest need it.
    const WarpFit visible = warp_fit(camera, light, scene, scene, near, far);
    const vec3 forward = visible.axes.to_light(camera.forward_ws);
    struct Candidate {
      float bound;
      Box group;
    };
    std::vector<Candidate> candidates;
    for (Box group : frame.scene().casters(true).groups) {
      group.min -= reach, group.max += reach;
      Box shadowed = visible.axes.bounds(group);
      shadowed.max.z = visible.bounds.max.z;
      shadowed.min = glm::max(shadowed.min, visible.bounds.min), shadowed.max = glm::min(shadowed.max, visible.bounds.max);
      if (glm::any(glm::greaterThan(shadowed.min, shadowed.max))) continue;
      float bound = near;
      for (int i = 0; i < 8; ++i) bound = std::max(bound, glm::dot(shadowed.corner(i) - visible.eye, forward));
      candidates.push_back({bound, group});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.bound > b.bound; });
    float farthest = near;
    int clips = 32;  // the rest by their bounds
    for (const auto& [bound, group] : candidates) {
      if (bound <= in_steps(farthest)) break;
      farthest = std::max(farthest, clips-- > 0 ? warp_fit(camera, light, group, scene, near, far).farthest_m : bound);
    }
    return in_steps(farthest);
  }

  // The splits of the whole distance decide how many cascades this frame needs; these then share what is needed (Zhang et al.
  // 2006, section 4.2). As few as leave no cascade longer than it is without adapt: under a mixed rule, one that ends in time
  // is not enough.
  Splits find_splits(const Frame& frame, const Light& light, uint32_t& count) const {
    const auto [near, far] = distance_range(frame);
    float needed = far;
    if (params_.adapt) {
      needed = needed_distance(frame, light, near, far);
      const auto as_fine = [&](uint32_t used) {
        for (uint32_t i = 1; i <= used; ++i) {
          if (split_at(near, needed, i, used) > 1.001f * split_at(near, far, i, count)) return false;
        }
        return true;
      };
      uint32_t used = 1;
      while (used < count && !as_fine(used)) ++used;
      count = used;
    }
    Splits splits = {};
    float last = near;
    for (uint32_t i = 0; i <= count; ++i) splits[i] = last = std::max(split_at(near, needed, i, count), last);
    return splits;
  }

  float split_at(float near, float far, uint32_t i, uint32_t count) const {
    if (i == 0) return near;
    if (i == count) return far;
    switch (params_.split) {
      case split_uniform:
        return mixed_split(near, far, i, count, 0.0f);
      case split_logarithmic:
        return mixed_split(near, far, i, count, 1.0f);
      case split_manual: {
        const float ends[] = {params_.split_1, params_.split_2, params_.split_3};
        const float end = near + (far - near) * ends[std::min(i, 3u) - 1];
        return i <= 3 ? end : mixed_split(end, far, i - 3, count - 3, 1.0f);
      }
      default:
        return mixed_split(near, far, i, count, params_.lambda);
    }
  }

  bool nested() const {
    return params_.nested && params_.selection == selection_map && params_.warp == warp_none && params_.near == near_casters;
  }

  // From the first caster, or from the slice: nearer casters are then clamped onto the map, or lost (near=slice). Under a
  // projector nothing is clamped, because what would be clamped may stand behind the light.
  std::pair<float, float> depths(const Bounds& bounds, float slice_near, float slice_far) const {
    Box receivers = bounds.scene;
    // A cascade that serves a column alone serves all of it.
    if (!nested()) receivers.max.z = std::min(receivers.max.z, std::max(slice_far, bounds.scene.min.z));
    Box casters = bounds.casters;
    if (params_.near == near_slice || (params_.near == near_clamp && !bounds.projector))
      casters.min.z = std::max(casters.min.z, std::min(slice_near, receivers.max.z));
    return depth_range(casters, receivers, bounds.start);
  }

  ShadowView sphere_view(const Frame& frame, const LightFrame& light_frame, const Bounds& bounds, float from, float to) const {
    const Sphere sphere = slice_sphere(frame.camera(), from, to);
    vec3 centre = light_frame.to_light(sphere.centre - frame.camera().forward_ws * (params_.offset * sphere.radius));
    const float size = static_cast<float>(params_.size);
    float half = sphere.radius * size / (size - 2.0f * border());
    if (params_.stabilise) {
      // Whole texels of the world: the map's grid stays where it was (Valient 2008). Along the light too: depths keep their
      // rounding.
      const float texel = with_few_bits(2.0f * half / size);
      half = 0.5f * texel * size;
      for (int axis = 0; axis < 3; ++axis) centre[axis] = std::round(centre[axis] / texel) * texel;
    }
    Box fit;
    fit.min = centre - vec3(half), fit.max = centre + vec3(half);
    const auto [near, far] = depths(bounds, centre.z - half, centre.z + half);
    return orthographic_view(light_frame, fit, near, far, map_size());
  }

  // A slice's ends differ little in distance: the formula holds without a guard, and the trapezoid's focus needs less than 80
  // %.
  ShadowView warped_slice(const Frame& frame, const Light& light, float from, float to) const {
    const WarpFit fit = warp_fit(frame.camera(), light, frame.scene().caster_bounds(), frame.scene().bounds(), from, to);
    const bool perspective = params_.warp == warp_light_space_perspective;
    return warped_view(fit,
                       perspective ? light_space_perspective_distance(fit, 0.0f, 1.0f) : trapezoidal_distance(fit, 0.5f, 0.6f),
                       map_size(), border());
  }

  ShadowView box_view(const Frame& frame, const Light& light, const LightFrame& light_frame, const Bounds& bounds, float from,
                      float to) const {
    Box fit;
    for (const vec3& corner : slice_corners(frame.camera(), from, to)) fit.add(light_frame.to_light(corner));
    const auto [near, far] = depths(bounds, fit.min.z, fit.max.z);
    // Only what is lit by the beam, belongs to the scene and lies behind a caster can be shadowed.
    clip_to_beam(light_frame, light, fit);
    for (int axis = 0; axis < 2; ++axis) {
      fit.min[axis] = std::max(fit.min[axis], std::max(bounds.scene.min[axis], bounds.casters.min[axis]));
      fit.max[axis] = std::min(fit.max[axis], std::min(bounds.scene.max[axis], bounds.casters.max[axis]));
    }
    add_border(fit, map_size(), border());
    if (params_.stabilise) {
      for (int axis = 0; axis < 2; ++axis) {
        // Sizes in steps of an eighth, so that a texel is the same over many frames.
        const float extent = some_extent(fit.max[axis] - fit.min[axis], fit.max[1 - axis] - fit.min[1 - axis]);
        const float step = std::exp2(std::floor(std::log2(extent))) / 8.0f;
        const float rounded = (std::floor(extent / step) + 2.0f) * step, texel = rounded / static_cast<float>(params_.size);
        fit.min[axis] = std::floor(fit.min[axis] / texel) * texel;
        fit.max[axis] = fit.min[axis] + rounded;
      }
    }
    return orthographic_view(light_frame, fit, near, far, map_size());
  }

  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::directional, LightKind::projector},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Cascaded>(params); }};
}

}  // namespace gnomon
