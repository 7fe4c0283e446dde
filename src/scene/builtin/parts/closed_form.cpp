// Silhouettes seen from the receiver, projected onto the sun's plane, and areas of polygons in a circle.
#include "scene/builtin/parts/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

// Twice the signed area, within the disc, of the triangle (origin, a, b).
double twice_sector_or_triangle(const dvec2& a, const dvec2& b, double radius) {
  const auto sector = [&](const dvec2& p, const dvec2& q) {
    return radius * radius * std::atan2(cross2(p, q), glm::dot(p, q));
  };
  const dvec2 along = b - a;
  const double aa = glm::dot(along, along);
  if (aa == 0.0) return 0.0;
  // The line's distance from the origin by the cross product: dot products cancel where corners are far away.
  const double half_b = glm::dot(a, along), moment = cross2(a, along);
  const double discriminant = aa * radius * radius - moment * moment;
  if (discriminant <= 0.0) return sector(a, b);  // the whole line misses the disc
  const double root = std::sqrt(discriminant);
  const double enter = std::clamp((-half_b - root) / aa, 0.0, 1.0), leave = std::clamp((-half_b + root) / aa, 0.0, 1.0);
  if (enter >= leave) return sector(a, b);
  const dvec2 p = a + enter * along, q = a + leave * along;
  return (enter > 0.0 ? sector(a, p) : 0.0) + cross2(p, q) + (leave < 1.0 ? sector(q, b) : 0.0);
}

// The sun as a point sees it.
struct SunDisc {
  dvec3 w, u, v;  // toward the centre; the plane's axes
  double radius;  // tan of half the angular diameter; 0 for a hard light
};

std::optional<SunDisc> sun_disc(const Light& light) {
  if (light.kind != LightKind::directional) return std::nullopt;
  SunDisc sun;
  sun.w = -glm::normalize(dvec3(light.direction));
  sun.u = glm::normalize(glm::cross(std::abs(sun.w.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), sun.w));
  sun.v = glm::cross(sun.w, sun.u);
  sun.radius = light.angular_diameter > 0.0f ? std::tan(0.5 * double(light.angular_diameter)) : 0.0;
  const double lowest = sun.w.y - sun.radius * std::sqrt(std::max(0.0, 1.0 - sun.w.y * sun.w.y));
  if (lowest <= 0.0) return std::nullopt;
  return sun;
}

// Metres. What is cut off lies closer to the receiver than this; corners stay within 1e6 of their distance on the sun's plane.
constexpr double k_nearest = 1e-6;

dvec2 projected(const SunDisc& sun, const dvec3& q) {
  return dvec2(glm::dot(q, sun.u), glm::dot(q, sun.v)) / glm::dot(q, sun.w);
}

// A planar convex polygon (corners relative to the receiver), cut to what lies in front of the receiver, on the sun's plane.
std::vector<dvec2> projected_polygon(const SunDisc& sun, std::span<const dvec3> corners) {
  std::vector<dvec2> result;
  for (size_t i = 0; i < corners.size(); ++i) {
    const dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double depth_a = glm::dot(a, sun.w) - k_nearest, depth_b = glm::dot(b, sun.w) - k_nearest;
    if (depth_a >= 0.0) result.push_back(projected(sun, a));
    if ((depth_a >= 0.0) != (depth_b >= 0.0)) result.push_back(projected(sun, glm::mix(a, b, depth_a / (depth_a - depth_b))));
  }
  return result;
}

// Andrew's monotone chain.
std::vector<dvec2> convex_hull(std::vector<dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<dvec2> hull;
  const auto chain = [&hull](auto begin, auto end) {
    const size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross2(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) hull.pop_back();
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();  // begins the other chain
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

double visible_fraction(const SunDisc& sun, std::span<const dvec2> polygon) {
  return std::clamp(1.0 - disc_polygon_overlap(polygon, sun.radius) / (glm::pi<double>() * sun.radius * sun.radius), 0.0, 1.0);
}

bool ray_hits_box(const dvec3& origin, const dvec3& direction, const BoxOccluder& box) {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) {
      if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return false;
      continue;
    }
    const double a = (box.min[axis] - origin[axis]) / direction[axis], b = (box.max[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

bool ray_hits_strips(const dvec3& origin, const dvec3& direction, const StripsOccluder& strips) {
  if (direction.x == 0.0) return false;  // along the plane, which has no thickness
  const double distance = -origin.x / direction.x;
  const dvec3 hit = origin + distance * direction;
  if (distance < 0.0 || hit.y < strips.lower || hit.y > strips.upper) return false;
  return std::any_of(strips.z_intervals.begin(), strips.z_intervals.end(),
                     [&](const dvec2& interval) { return hit.z >= interval.x && hit.z <= interval.y; });
}

// The rim of the sphere as seen from the origin: the circle where tangents touch, scaled so that the polygon has its area.
std::vector<dvec3> sphere_rim(const dvec3& centre, double radius) {
  constexpr int k_corners = 2048;
  const double distance2 = glm::dot(centre, centre), shrink = 1.0 - radius * radius / distance2;
  const double step = 2.0 * glm::pi<double>() / k_corners;
  const double rim_radius = radius * std::sqrt(shrink) * std::sqrt(step / std::sin(step));
  const dvec3 axis = centre / std::sqrt(distance2);
  const dvec3 side = glm::normalize(glm::cross(std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), axis));
  const dvec3 other = glm::cross(axis, side);
  std::vector<dvec3> rim(k_corners);
  for (int i = 0; i < k_corners; ++i) {
    rim[static_cast<size_t>(i)] = centre * shrink + rim_radius * (std::cos(i * step) * side + std::sin(i * step) * other);
  }
  return rim;
}

}  // namespace

double disc_polygon_overlap(std::span<const dvec2> polygon, double radius) {
  double twice_area = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    twice_area += twice_sector_or_triangle(polygon[i], polygon[(i + 1) % polygon.size()], radius);
  }
  return 0.5 * std::abs(twice_area);
}

std::optional<double> closed_form_visibility(const dvec3& point, const Light& light, const BoxOccluder& occluder) {
  const auto sun = sun_disc(light);
  if (!sun) return std::nullopt;
  if (sun->radius == 0.0) return ray_hits_box(point, sun->w, occluder) ? 0.0 : 1.0;
  const auto corner = [&](int index) {
    return dvec3(index & 1 ? occluder.max.x : occluder.min.x, index & 2 ? occluder.max.y : occluder.min.y,
                 index & 4 ? occluder.max.z : occluder.min.z) -
           point;
  };
  std::vector<dvec2> seen;  // the ends of all edges, cut to the front: their hull is the silhouette
  for (int low = 0; low < 8; ++low) {
    for (const int axis : {1, 2, 4}) {
      if (low & axis) continue;
      const std::array<dvec3, 2> edge = {corner(low), corner(low | axis)};
      const auto ends = projected_polygon(*sun, edge);
      seen.insert(seen.end(), ends.begin(), ends.end());
    }
  }
  if (seen.empty()) return 1.0;
  return visible_fraction(*sun, convex_hull(std::move(seen)));
}

std::optional<double> closed_form_visibility(const dvec3& point, const Light& light, const SphereOccluder& occluder) {
  const auto sun = sun_disc(light);
  if (!sun) return std::nullopt;
  const dvec3 centre = occluder.centre - point;
  const double distance = glm::length(centre), along = glm::dot(centre, sun->w), across = glm::length(centre - along * sun->w);
  if (distance <= occluder.radius) return std::nullopt;
  if (sun->radius == 0.0) return along > 0.0 && across <= occluder.radius ? 0.0 : 1.0;
  // Two caps on the unit sphere: apart, one in the other, or overlapping.
  const double sun_angle = std::atan(sun->radius), sphere_angle = std::asin(occluder.radius / distance);
  const double between = std::atan2(across, along);
  if (between >= sun_angle + sphere_angle) return 1.0;
  if (between <= sphere_angle - sun_angle) return 0.0;
  return visible_fraction(*sun, projected_polygon(*sun, sphere_rim(centre, occluder.radius)));
}

std::optional<double> closed_form_visibility(const dvec3& point, const Light& light, const StripsOccluder& occluder) {
  const auto sun = sun_disc(light);
  if (!sun) return std::nullopt;
  if (sun->radius == 0.0) return ray_hits_strips(point, sun->w, occluder) ? 0.0 : 1.0;
  double visible = 1.0;
  for (const dvec2& z : occluder.z_intervals) {
    const std::array<dvec3, 4> corners = {dvec3(0, occluder.lower, z.x) - point, dvec3(0, occluder.lower, z.y) - point,
                                          dvec3(0, occluder.upper, z.y) - point, dvec3(0, occluder.upper, z.x) - point};
    visible -= 1.0 - visible_fraction(*sun, projected_polygon(*sun, corners));
  }
  return std::clamp(visible, 0.0, 1.0);
}

}  // namespace gnomon
