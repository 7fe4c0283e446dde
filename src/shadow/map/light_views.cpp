// Views of a light.
#include "shadow/map/light_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {

LightFrame::LightFrame(const vec3& direction) {
  vec3 x, y;
  orthonormal_basis(direction, x, y);
  world_from_light = mat3(x, y, direction);
}

Box LightFrame::bounds(const Box& box) const {
  Box result;
  for (int i = 0; i < 8; ++i) result.add(to_light(box.corner(i)));
  return result;
}

ShadowView projective_view(const mat4& clip_from_world, const vec4& depth_plane, float depth_near_m, float depth_range_m,
                           float texel_m, uint32_t size) {
  ShadowView view = {};
  view.raster.clip_from_world = clip_from_world;
  view.raster.kind = k_view_projective;
  view.raster.in_use = 1;
  // In double precision: maps of kilometres with texels of millimetres.
  const glm::dmat4 inverse = glm::inverse(glm::dmat4(clip_from_world));
  view.world_from_clip = mat4(inverse);
  view.linear_numerator = vec4(glm::dvec4(depth_plane) * inverse);
  view.linear_denominator = vec4(glm::dvec4(0, 0, 0, 1) * inverse);
  view.depth_near_m = depth_near_m;
  view.depth_range_m = depth_range_m;
  view.texel_m = texel_m;
  view.size = static_cast<float>(size);
  view.interval_m = vec2(0.0f, 3.0e38f);
  return view;
}

float some_extent(float extent, float others) { return std::max(extent, others > 0.0f ? 1e-3f * others : 1e-6f); }

ShadowView orthographic_view(const LightFrame& light, const Box& fit, float near, float far, uint32_t size) {
  // A view that sees no caster keeps a small valid map; everything is then outside it and lit.
  const vec2 across = vec2(fit.max) - vec2(fit.min);
  const float largest = std::max({across.x, across.y, far - near});
  const float width = some_extent(across.x, largest), height = some_extent(across.y, largest),
              depth = some_extent(far - near, largest);
  mat4 clip_from_light(0.0f);
  clip_from_light[0][0] = 2.0f / width;
  clip_from_light[1][1] = 2.0f / height;
  clip_from_light[2][2] = 1.0f / depth;
  clip_from_light[3] = vec4(-(2.0f * fit.min.x + width) / width, -(2.0f * fit.min.y + height) / height, -near / depth, 1.0f);
  const vec3 along = light.world_from_light[2];
  return projective_view(clip_from_light * mat4(glm::transpose(light.world_from_light)), vec4(along / depth, -near / depth),
                         0.0f, depth, std::max(width, height) / static_cast<float>(size), size);
}

ShadowView perspective_view(const vec3& position, const mat3& axes, float half_angle, float near, float far, uint32_t size) {
  const float slope = std::tan(half_angle);
  mat4 clip_from_view(0.0f);
  clip_from_view[0][0] = clip_from_view[1][1] = 1.0f / slope;
  clip_from_view[2][2] = far / (far - near);
  clip_from_view[3][2] = -far * near / (far - near);
  clip_from_view[2][3] = 1.0f;
  mat4 view_from_world(glm::transpose(axes));
  view_from_world[3] = vec4(-(glm::transpose(axes) * position), 1.0f);
  const vec4 depth_plane(axes[2] / (far - near), (-glm::dot(axes[2], position) - near) / (far - near));
  ShadowView view = projective_view(clip_from_view * view_from_world, depth_plane, near, far - near,
                                    2.0f * slope / static_cast<float>(size), size);
  view.origin_ws = position;
  return view;
}

std::pair<float, float> distance_range(const vec3& position, float light_range, const Box& casters, const Box& scene) {
  float far = 0.0f;
  for (int i = 0; i < 8; ++i) far = std::max(far, glm::length(scene.corner(i) - position));
  if (light_range > 0.0f) far = std::min(far, light_range);
  const float outside = glm::length(glm::max(glm::max(casters.min - position, position - casters.max), vec3(0.0f)));
  far = std::max(far * 1.001f, 1e-12f);
  // Inside the casters' box the first one may be anywhere: a thousandth of the reach keeps the depth of 32 bits exact to a
  // tenth of that.
  const float near = std::clamp(0.95f * outside / std::sqrt(3.0f), far * 1e-3f, 0.5f * far);
  return {near, far};
}

float light_start(const LightFrame& frame, const Light& light) {
  return light.kind == LightKind::projector ? frame.to_light(light.position).z : std::numeric_limits<float>::lowest();
}

std::pair<float, float> depth_range(const Box& casters_in_light, const Box& receivers_in_light, float start) {
  const float far = receivers_in_light.max.z, near = std::min(std::max(casters_in_light.min.z, start), far);
  const vec3 extent = receivers_in_light.extent();
  const float margin = 1e-3f * some_extent(far - near, std::max(extent.x, extent.y));
  return {std::max(near - margin, start), far + margin};
}

void clip_to_beam(const LightFrame& frame, const Light& light, Box& fit) {
  if (light.kind != LightKind::projector) return;
  const vec3 centre = frame.to_light(light.position);
  for (int axis = 0; axis < 2; ++axis) {
    fit.min[axis] = std::max(fit.min[axis], centre[axis] - light.beam_radius);
    fit.max[axis] = std::min(fit.max[axis], centre[axis] + light.beam_radius);
  }
}

void add_border(Box& fit, uint32_t size, float border) {
  const float grow = border / std::max(static_cast<float>(size) - 2.0f * border, 1.0f);
  for (int axis = 0; axis < 2; ++axis) {
    const float extent = fit.max[axis] - fit.min[axis];
    fit.min[axis] -= grow * extent;
    fit.max[axis] += grow * extent;
  }
}

}  // namespace gnomon
