// Perspective warps of a parallel light's map.
#include "shadow/map/warp.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using Polygon = std::vector<dvec3>;

// Corners of the cap that a cut leaves, in order around it.
Polygon ordered_around(Polygon points, const dvec3& normal) {
  if (points.size() < 3) return {};
  dvec3 centre(0.0);
  for (const dvec3& p : points) centre += p / static_cast<double>(points.size());
  const dvec3 x =
      glm::normalize(std::abs(normal.x) < 0.7 ? glm::cross(normal, dvec3(1, 0, 0)) : glm::cross(normal, dvec3(0, 1, 0)));
  const dvec3 y = glm::cross(normal, x);
  const auto angle = [&](const dvec3& p) { return std::atan2(glm::dot(p - centre, y), glm::dot(p - centre, x)); };
  std::sort(points.begin(), points.end(), [&](const dvec3& a, const dvec3& b) { return angle(a) < angle(b); });
  return points;
}

// Sutherland and Hodgman 1974; appends where edges are cut to `cap`.
Polygon clipped(const Polygon& polygon, const dvec4& plane, Polygon& cap) {
  Polygon result;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = glm::dot(plane, dvec4(a, 1.0)), db = glm::dot(plane, dvec4(b, 1.0));
    if (da >= 0.0) result.push_back(a);
    if ((da >= 0.0) == (db >= 0.0)) continue;
    const dvec3 cut = a + (b - a) * (da / (da - db));
    result.push_back(cut);
    cap.push_back(cut);
  }
  return result;
}

// Inward planes of a box whose axes are the columns of `axes`; the first `count` dimensions.
void add_box_planes(const mat3& axes, const Box& box, int count, std::vector<vec4>& planes) {
  for (int axis = 0; axis < count; ++axis) {
    planes.emplace_back(axes[axis], -box.min[axis]);
    planes.emplace_back(-axes[axis], box.max[axis]);
  }
}

LightFrame axes_along_view(const vec3& light, const vec3& forward) {
  LightFrame frame(light);
  const vec3 along = forward - light * glm::dot(forward, light);
  const float length = glm::length(along);
  if (length < 1e-4f) return frame;
  const vec3 y = along / length;
  frame.world_from_light = mat3(glm::cross(y, light), y, light);
  return frame;
}

}  // namespace

std::vector<vec3> clipped_corners(const std::array<vec3, 8>& slice, std::span<const vec4> planes) {
  constexpr int k_faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  std::vector<Polygon> faces;
  for (const auto& face : k_faces) {
    Polygon polygon;
    for (const int corner : face) polygon.emplace_back(slice[static_cast<size_t>(corner)]);
    faces.push_back(std::move(polygon));
  }
  for (const vec4& plane : planes) {
    // Most planes leave all of it, or nothing.
    bool all_inside = true, any_inside = false;
    for (const Polygon& face : faces) {
      for (const dvec3& p : face) {
        const bool inside = glm::dot(dvec4(plane), dvec4(p, 1.0)) >= 0.0;
        all_inside = all_inside && inside, any_inside = any_inside || inside;
      }
    }
    if (all_inside) continue;
    if (!any_inside) return {};
    Polygon cap;
    for (Polygon& face : faces) face = clipped(face, dvec4(plane), cap);
    faces.push_back(ordered_around(std::move(cap), glm::normalize(dvec3(plane))));
    std::erase_if(faces, [](const Polygon& face) { return face.size() < 3; });
  }
  std::vector<vec3> corners;
  for (const Polygon& face : faces) corners.insert(corners.end(), face.begin(), face.end());
  return corners;
}

WarpFit warp_fit(const CameraData& camera, const Light& light, const Box& casters, const Box& scene, float from_m, float to_m) {
  WarpFit fit = {
      axes_along_view(light.direction, camera.forward_ws), {}, {}, {}, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, camera.orthographic != 0};
  const mat3& axes = fit.axes.world_from_light;
  Box shadowed = fit.axes.bounds(casters.empty() ? scene : casters);  // without casters any fit will do
  fit.first_caster_z = shadowed.min.z;
  fit.start_z = light_start(fit.axes, light);
  fit.first_caster_z = std::max(fit.first_caster_z, fit.start_z);
  clip_to_beam(fit.axes, light, shadowed);
  std::vector<vec4> planes;
  add_box_planes(mat3(1.0f), scene, 3, planes);
  add_box_planes(axes, shadowed, 2, planes);
  planes.emplace_back(axes[2], -fit.first_caster_z);
  fit.eye = fit.axes.to_light(camera.eye_ws);
  fit.sine = glm::length(glm::cross(camera.forward_ws, light.direction));
  fit.nearest_m = std::numeric_limits<float>::max();
  for (const vec3& corner : clipped_corners(slice_corners(camera, from_m, to_m), planes)) {
    fit.body.push_back(fit.axes.to_light(corner));
    fit.bounds.add(fit.body.back());
    const float depth = glm::dot(corner - camera.eye_ws, camera.forward_ws);
    fit.nearest_m = std::min(fit.nearest_m, depth), fit.farthest_m = std::max(fit.farthest_m, depth);
  }
  return fit;
}

float light_space_perspective_distance(const WarpFit& fit, float nearest, float strength) {
  if (fit.body.empty() || fit.orthographic || fit.sine < 1e-4f || strength <= 0.0f) return k_no_warp;
  const float first = std::max(fit.nearest_m, nearest * (fit.farthest_m - fit.nearest_m));
  // As the authors' program does: the near plane as the light sees it, and the far one from the body's length in the light's
  // plane.
  const float z_n = first / fit.sine, z_f = z_n + fit.bounds.extent().y * fit.sine;
  return (z_n + std::sqrt(z_n * z_f)) / (fit.sine * strength);
}

float trapezoidal_distance(const WarpFit& fit, float focus, float share) {
  if (fit.body.empty() || fit.orthographic) return k_no_warp;
  const float length = fit.bounds.extent().y;
  const float focus_depth = fit.nearest_m + focus * (fit.farthest_m - fit.nearest_m);
  // y grows by the sine for each metre of view depth.
  const float focus_y = std::max(fit.eye.y + focus_depth * fit.sine - fit.bounds.min.y, 0.01f * length);
  // Along the view the trapezoid says nothing (the near side lies inside the far one): fade to uniform.
  const float t = std::clamp(2.0f * fit.sine, 0.0f, 1.0f), known = t * t * (3.0f - 2.0f * t);
  const float below = (share * length - focus_y) * known;
  if (below <= 1e-5f * length) return k_no_warp;
  return length * focus_y * (1.0f - share) / below;
}

ShadowView warped_view(const WarpFit& fit, float apex_distance, uint32_t size, float border) {
  // w = 1 + (y - y0) / n is 1 at the near side. (x - x0) / w and (y - y0) / w tend to x and y as n grows: no digits are lost.
  const double bend =
      apex_distance >= k_no_warp ? 0.0 : 1.0 / std::max(double(apex_distance), 1e-4 * double(fit.bounds.extent().y) + 1e-30);
  const dvec2 origin = fit.body.empty() ? dvec2(0.0) : dvec2(fit.eye.x, fit.bounds.min.y);
  dvec2 low(1e30), high(-1e30);
  float far = fit.first_caster_z;
  for (const vec3& p : fit.body) {
    const dvec2 flat = (dvec2(p) - origin) / (1.0 + bend * (double(p.y) - origin.y));
    low = glm::min(low, flat), high = glm::max(high, flat);
    far = std::max(far, p.z);
  }
  // A view that sees nothing keeps a small valid map.
  if (fit.body.empty()) low = dvec2(0.0), high = dvec2(0.0);
  dvec2 extent = high - low;
  const auto far_m = static_cast<float>(double(far) - double(fit.first_caster_z));
  const float largest = std::max({static_cast<float>(extent.x), static_cast<float>(extent.y), far_m});
  for (int axis = 0; axis < 2; ++axis) extent[axis] = double(some_extent(static_cast<float>(extent[axis]), largest));
  extent *= double(size) / std::max(double(size) - 2.0 * double(border), 0.5 * double(size));
  const dvec2 middle = 0.5 * (low + high);
  const double margin = 1e-3 * double(some_extent(far_m, largest));
  const double near = std::max(double(fit.first_caster_z) - margin, double(fit.start_z)), depth = double(far) + margin - near;

  // Rows, applied to (x, y, z, 1) of the axes.
  const dvec4 w(0.0, bend, 0.0, 1.0 - bend * origin.y);
  const dvec4 x = (dvec4(1, 0, 0, -origin.x) - middle.x * w) * (2.0 / extent.x);
  const dvec4 y = (dvec4(0, 1, 0, -origin.y) - middle.y * w) * (2.0 / extent.y);
  const dvec4 z(0.0, 0.0, 1.0 / depth, -near / depth);
  const glm::dmat4 clip_from_light = glm::transpose(glm::dmat4(x, y, z, w));
  const glm::dmat4 light_from_world(glm::transpose(glm::dmat3(fit.axes.world_from_light)));
  const vec3 along = fit.axes.world_from_light[2];
  const auto range = static_cast<float>(depth);
  ShadowView view =
      projective_view(mat4(clip_from_light * light_from_world), vec4(along / range, static_cast<float>(-near / depth)), 0.0f,
                      range, static_cast<float>(extent.x / double(size)), size);
  view.texel_along_m = static_cast<float>(extent.y / double(size));
  view.border = border;
  return view;
}

}  // namespace gnomon
