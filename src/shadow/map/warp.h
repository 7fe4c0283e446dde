// Perspective warps of a parallel light's map (Wimmer et al. 2004; Martin and Tan 2004): a projective map in the light's plane,
// along the view direction, gives what is near the viewer more texels. Parallel light stays parallel: x and y of the map do not
// depend on the depth. What the two methods differ in is one number, the distance from the near side of what is visible to the
// warp's apex.
#pragma once

#include <span>
#include <vector>

#include "shadow/map/light_views.h"
#include "shadow/map/projection.h"

namespace gnomon {

// The corners of the part of a hexahedron (as slice_corners gives it) where dot(plane, (p, 1)) >= 0 for every plane. Empty
// where there is none.
std::vector<vec3> clipped_corners(const std::array<vec3, 8>& slice, std::span<const vec4> planes);

// What a warped map must hold.
struct WarpFit {
  LightFrame axes;         // y is the view direction in the light's plane
  std::vector<vec3> body;  // in axes: corners of what the camera can see between two distances, and a caster can shadow
  Box bounds;              // of the body
  vec3 eye;                // in axes
  float first_caster_z;
  float start_z;                // light_start()
  float sine;                   // of the angle between light and view
  float nearest_m, farthest_m;  // view depths of the body
  bool orthographic;            // of the viewer's camera: there is no perspective to follow
};
WarpFit warp_fit(const CameraData& camera, const Light& light, const Box& casters, const Box& scene, float from_m, float to_m);

// Distance of the apex, metres; k_no_warp: a uniform map, to which both go smoothly as the light turns along the view.
inline constexpr float k_no_warp = 3.0e38f;

// Wimmer, Scherzer, Purgathofer 2004, section 4.2: n = (z_n + sqrt(z_n z_f)) / sin(gamma), which levels the perspective error
// over the view. The first visible thing is rarely at the near plane: z_n is at least `nearest` of the visible depth.
// `strength` divides n.
float light_space_perspective_distance(const WarpFit& fit, float nearest, float strength);

// Martin and Tan 2004, section 5: the nearest `focus` of the visible depth is given `share` of the map (the 80 % rule).
float trapezoidal_distance(const WarpFit& fit, float focus, float share);

// The view that holds the body with `border` texels around it.
ShadowView warped_view(const WarpFit& fit, float apex_distance, uint32_t size, float border);

// A projection of one warped map of what the camera sees. Params: of a table with size and border.
template <class Params>
class WarpedProjection : public Projection {
 public:
  explicit WarpedProjection(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) final { params_ = params.as<Params>(); }
  uint32_t map_size() const final { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const final { return 1; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const final {
    const auto [near, far] = frame.visible_range();
    const WarpFit fit = warp_fit(frame.camera(), light, frame.scene().caster_bounds(), frame.scene().bounds(), near, far);
    return {warped_view(fit, apex_distance(fit), map_size(), params_.border)};
  }

 protected:
  virtual float apex_distance(const WarpFit& fit) const = 0;
  Params params_;
};

}  // namespace gnomon
