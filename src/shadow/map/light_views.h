// Views of a light: what projections share. Clip space: x and y in [-w, w], depth 0 near the light to 1.
#pragma once

#include "frame/frame.h"
#include "shadow/map/glsl/map_data.glsl"

namespace gnomon {

// Axes of a parallel light: x and y across it, z along it (metres).
struct LightFrame {
  mat3 world_from_light;
  explicit LightFrame(const vec3& direction);
  vec3 to_light(const vec3& p) const { return glm::transpose(world_from_light) * p; }
  Box bounds(const Box& box) const;  // of the eight corners
};

// A view whose map is square. `depth_plane`: dot with (position, 1) is the linear depth; metres from the light at linear depth
// 0, and from there to 1. `texel_m`: side of a texel where clip w is 1.
ShadowView projective_view(const mat4& clip_from_world, const vec4& depth_plane, float depth_near_m, float depth_range_m,
                           float texel_m, uint32_t size);

// An extent that may be none, as a map needs one: at least a thousandth of the others (of a millimetre where all are none).
float some_extent(float extent, float others);

// Along a parallel light, of the box `fit` (x and y) between the depths near and far of the light's z.
ShadowView orthographic_view(const LightFrame& light, const Box& fit, float near, float far, uint32_t size);

// From a point: half_angle (radians, below a right angle) from the axis to the edge of the map. `axes`: columns x, y, z; looks
// along z.
ShadowView perspective_view(const vec3& position, const mat3& axes, float half_angle, float near, float far, uint32_t size);

// Distances from a point between which its light can meet a caster and, after it, a receiver: {near, far}, near > 0.
std::pair<float, float> distance_range(const vec3& position, float light_range, const Box& casters, const Box& scene);

// The depth at which a parallel light begins: what stands before a projector's aperture shadows nothing. A sun: no such depth.
float light_start(const LightFrame& frame, const Light& light);

// Depths along a parallel light from the first caster to the last receiver, with a margin so that neither lies on a plane, but
// not before `start`.
std::pair<float, float> depth_range(const Box& casters_in_light, const Box& receivers_in_light, float start);

// The light-space box of a projector's beam (x and y); anything for a sun.
void clip_to_beam(const LightFrame& frame, const Light& light, Box& fit);

// Widens a fit so that a kernel of `border` texels at its edge still finds the map.
void add_border(Box& fit, uint32_t size, float border);

}  // namespace gnomon
