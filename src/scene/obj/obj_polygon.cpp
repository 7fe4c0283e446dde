// Ear clipping in the polygon's plane (Meisters 1975), fans where the polygon is convex.
#include "scene/obj/obj_polygon.h"

#include <cmath>
#include <numeric>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;

// Above 0: counter-clockwise.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// The corners seen along the axis in which the polygon's area is largest, counter-clockwise, relative to the first corner:
// a unit quad 14 km from the origin keeps its digits.
std::vector<dvec2> flatten(std::span<const vec3> polygon) {
  const dvec3 origin(polygon[0]);
  dvec3 area(0.0);  // Newell
  for (size_t i = 0; i < polygon.size(); ++i) {
    area += glm::cross(dvec3(polygon[i]) - origin, dvec3(polygon[(i + 1) % polygon.size()]) - origin);
  }
  const dvec3 size = glm::abs(area);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double sign = area[axis] < 0.0 ? -1.0 : 1.0;
  std::vector<dvec2> points;
  points.reserve(polygon.size());
  for (const vec3& corner : polygon) {
    const dvec3 p = dvec3(corner) - origin;
    points.emplace_back(p[u] * sign, p[v]);
  }
  return points;
}

bool convex(const std::vector<dvec2>& points) {
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) {
    if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0.0) return false;
  }
  return true;
}

bool inside(const dvec2& p, const dvec2& a, const dvec2& b, const dvec2& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

class EarClipper {
 public:
  explicit EarClipper(const std::vector<dvec2>& points) : points_(points), corners_(points.size()) {
    std::iota(corners_.begin(), corners_.end(), 0u);
  }

  void clip(std::vector<std::array<uint32_t, 3>>& triangles) {
    size_t i = 0;
    while (corners_.size() > 3) {
      i = next_ear(i);
      triangles.push_back({corner(i + corners_.size() - 1), corner(i), corner(i + 1)});
      corners_.erase(corners_.begin() + static_cast<ptrdiff_t>(i % corners_.size()));
      // The neighbour after next: clipping around the polygon instead of fanning out from one corner.
      ++i;
    }
    triangles.push_back({corners_[0], corners_[1], corners_[2]});
  }

 private:
  uint32_t corner(size_t i) const { return corners_[i % corners_.size()]; }

  size_t next_ear(size_t start) const {
    const size_t n = corners_.size();
    size_t flat = n;
    for (size_t k = 0; k < n; ++k) {
      const size_t i = (start + k) % n;
      const dvec2 &a = points_[corner(i + n - 1)], &b = points_[corner(i)], &c = points_[corner(i + 1)];
      const double area = turn(a, b, c);
      if (area > 0.0 && !contains_a_corner(i, a, b, c)) return i;
      if (area == 0.0 && flat == n) flat = i;
    }
    // None is left only where edges cross or coincide: a corner without area does no harm, and something must go.
    return flat != n ? flat : start % n;
  }

  bool contains_a_corner(size_t ear, const dvec2& a, const dvec2& b, const dvec2& c) const {
    const size_t n = corners_.size();
    for (size_t k = 2; k + 1 < n; ++k) {
      const dvec2& p = points_[corner(ear + k)];
      // Bridges to a hole visit the same place twice; that place is no obstacle.
      if (p != a && p != b && p != c && inside(p, a, b, c)) return true;
    }
    return false;
  }

  const std::vector<dvec2>& points_;
  std::vector<uint32_t> corners_;
};

}  // namespace

bool triangulate(std::span<const vec3> polygon, std::vector<std::array<uint32_t, 3>>& triangles) {
  const auto n = static_cast<uint32_t>(polygon.size());
  if (n == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  const auto points = flatten(polygon);
  if (!convex(points)) {
    if (n > k_max_concave_corners) return false;
    EarClipper(points).clip(triangles);
    return true;
  }
  // The shorter diagonal of a quad that is not quite plane makes the better shape.
  const auto diagonal = [&](size_t a, size_t b) { return glm::length(dvec3(polygon[a]) - dvec3(polygon[b])); };
  const uint32_t apex = n == 4 && diagonal(1, 3) < diagonal(0, 2) ? 1 : 0;
  for (uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({apex, (apex + i) % n, (apex + i + 1) % n});
  return true;
}

}  // namespace gnomon
