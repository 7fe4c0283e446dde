// Closed forms of the charts against brute force on the same primitives (own ray tests, stratified disc), and against cases
// that have a formula of their own.
#include "scene/builtin/parts/closed_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double k_pi_d = 3.14159265358979323846;

Light sun(const dvec3& direction, double diameter_degrees) {
  Light light;
  light.direction = vec3(glm::normalize(direction));
  light.angular_diameter = static_cast<float>(diameter_degrees * k_pi_d / 180.0);
  return light;
}

// Orthonormal axes around the direction toward the sun, built otherwise than in the code under test.
struct Frame {
  dvec3 w, u, v;
  double radius;
};
Frame frame_of(const Light& light) {
  Frame frame;
  frame.w = -glm::normalize(dvec3(light.direction));
  frame.u = glm::normalize(glm::cross(frame.w, dvec3(0.3, 0.2, 0.9)));
  frame.v = glm::cross(frame.w, frame.u);
  frame.radius = std::tan(0.5 * double(light.angular_diameter));
  return frame;
}

// Rings of equal area, each turned against the last.
template <class Blocked>
double brute_force(const Light& light, const Blocked& blocked) {
  constexpr int k_rings = 300, k_spokes = 400;
  const Frame f = frame_of(light);
  int visible = 0;
  for (int i = 0; i < k_rings; ++i) {
    const double r = f.radius * std::sqrt((i + 0.5) / k_rings);
    for (int j = 0; j < k_spokes; ++j) {
      const double phi = 2.0 * k_pi_d * (j + 0.61803398875 * i) / k_spokes;
      visible += blocked(f.w + r * (std::cos(phi) * f.u + std::sin(phi) * f.v)) ? 0 : 1;
    }
  }
  return double(visible) / (k_rings * k_spokes);
}

bool hits_box(const dvec3& p, const dvec3& d, const BoxOccluder& box) {
  // The lowest and highest height at which the ray (d.y > 0) is inside in x and z.
  double low = (box.min.y - p.y) / d.y, high = (box.max.y - p.y) / d.y;
  for (const int axis : {0, 2}) {
    const double a = (box.min[axis] - p[axis]) / d[axis], b = (box.max[axis] - p[axis]) / d[axis];
    low = std::max(low, std::min(a, b)), high = std::min(high, std::max(a, b));
  }
  return low <= high && high >= 0.0;
}

bool hits_sphere(const dvec3& p, const dvec3& d, const SphereOccluder& sphere) {
  const dvec3 to_centre = sphere.centre - p;
  const double t = glm::dot(to_centre, d) / glm::dot(d, d);
  return t > 0.0 && glm::length(to_centre - t * d) <= sphere.radius;
}

bool hits_strips(const dvec3& p, const dvec3& d, const StripsOccluder& strips) {
  const double t = -p.x / d.x, y = p.y + t * d.y, z = p.z + t * d.z;
  if (t < 0.0 || y < strips.lower || y > strips.upper) return false;
  for (const dvec2& interval : strips.z_intervals) {
    if (z >= interval.x && z <= interval.y) return true;
  }
  return false;
}

constexpr double k_brute_force_error = 1.5e-3;

// Compares at points of a grid on the floor; returns how many were partly lit, so that a test cannot pass without any.
template <class Occluder, class Hits>
int compare_on_floor(const Light& light, const Occluder& occluder, const Hits& hits, const dvec2& from, const dvec2& to,
                     int side) {
  int partial = 0;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const dvec2 at = glm::mix(from, to, dvec2(i + 0.37, j + 0.61) / double(side));
      const dvec3 point(at.x, 0.0, at.y);
      const auto exact = closed_form_visibility(point, light, occluder);
      EXPECT_TRUE(exact.has_value());
      if (!exact) continue;
      if (light.angular_diameter == 0.0f) {
        EXPECT_EQ(*exact, hits(point, -glm::normalize(dvec3(light.direction)), occluder) ? 0.0 : 1.0) << at.x << ' ' << at.y;
        continue;
      }
      const double sampled = brute_force(light, [&](const dvec3& d) { return hits(point, d, occluder); });
      EXPECT_NEAR(*exact, sampled, k_brute_force_error) << at.x << ' ' << at.y;
      partial += *exact > 0.01 && *exact < 0.99 ? 1 : 0;
    }
  }
  return partial;
}

const dvec3 k_slanted(0.6, -0.7, 0.2);

TEST(closed_form, box_matches_brute_force) {
  const BoxOccluder box{{-3, 1, -2}, {0, 1.25, 2}};
  compare_on_floor(sun(k_slanted, 0.0), box, hits_box, {-5, -4}, {4, 5}, 60);
  EXPECT_GT(compare_on_floor(sun(k_slanted, 4.0), box, hits_box, {0.6, 0.0}, {1.4, 3.2}, 9), 10);  // an edge and a corner
  EXPECT_GT(compare_on_floor(sun({0.01, -1, 0.02}, 4.0), box, hits_box, {-0.06, -0.5}, {0.06, 0.5}, 6),
            10);  // both lower and upper edge
}

TEST(closed_form, sphere_matches_brute_force) {
  const SphereOccluder sphere{{0, 1.0, 0}, 0.5};
  compare_on_floor(sun(k_slanted, 0.0), sphere, hits_sphere, {-1, -1}, {3, 2}, 60);
  EXPECT_GT(compare_on_floor(sun(k_slanted, 5.0), sphere, hits_sphere, {0.0, -0.6}, {1.7, 1.2}, 9), 10);
  const SphereOccluder resting{{0, 0.5, 0}, 0.5};
  EXPECT_GT(compare_on_floor(sun({0.9, -0.3, 0.1}, 5.0), resting, hits_sphere, {0.6, -0.7}, {4.0, 0.9}, 9), 10);
}

TEST(closed_form, strips_match_brute_force) {
  const StripsOccluder strips{{{-1.0, -0.8}, {-0.6, -0.4}, {0.0, 0.05}, {0.1, 0.9}}, 0.3, 1.8};
  compare_on_floor(sun(k_slanted, 0.0), strips, hits_strips, {-1, -2}, {3, 2}, 60);
  EXPECT_GT(compare_on_floor(sun(k_slanted, 3.0), strips, hits_strips, {0.1, -1.2}, {1.8, 1.6}, 14), 20);
}

// Fraction of a disc on one side of a chord at signed distance x radii from its centre.
double segment(double x) { return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / k_pi_d; }

TEST(closed_form, a_long_edge_hides_a_circular_segment) {
  const Light light = sun({0, -1, 0}, 2.0);
  const double radius = std::tan(0.5 * double(light.angular_diameter)), height = 2.0;
  const BoxOccluder half_plane{{-1e4, height, -1e4}, {0, height + 1e-9, 1e4}};
  for (const double x : {-0.95, -0.5, -0.1, 0.0, 0.3, 0.8}) {  // where the edge stands, in radii of the sun
    const auto visible = closed_form_visibility({-x * radius * height, 0, 0.3}, light, half_plane);
    ASSERT_TRUE(visible.has_value());
    EXPECT_NEAR(*visible, segment(x), 1e-9);
  }
}

TEST(closed_form, a_sphere_in_the_middle_of_the_sun_leaves_a_ring) {
  const Light light = sun({0, -1, 0}, 4.0);
  const double radius = std::tan(0.5 * double(light.angular_diameter));
  const SphereOccluder sphere{{0, 10, 0}, 0.2};
  const double covered = std::tan(std::asin(sphere.radius / 10.0)) / radius;
  EXPECT_NEAR(closed_form_visibility({0, 0, 0}, light, sphere).value(), 1.0 - covered * covered, 1e-7);
}

// The sphere's outline in the sun's plane is a conic; along each ray from the sun's centre the covered part is one interval.
double sphere_by_quadrature(const dvec3& point, const Light& light, const SphereOccluder& sphere) {
  constexpr int k_steps = 200000;
  const Frame f = frame_of(light);
  const dvec3 c = sphere.centre - point;
  const double k = glm::dot(c, c) - sphere.radius * sphere.radius;  // inside: (d.c)^2 >= d.d k
  const double along = glm::dot(f.w, c);
  double covered = 0.0;
  for (int i = 0; i < k_steps; ++i) {
    const double phi = 2.0 * k_pi_d * (i + 0.5) / k_steps;
    const double slope = glm::dot(std::cos(phi) * f.u + std::sin(phi) * f.v, c);
    const double a = slope * slope - k, b = along * slope, e = along * along - k;  // a r^2 + 2 b r + e >= 0, a < 0 near the sun
    const double root2 = b * b - a * e;
    if (root2 <= 0.0) continue;
    const double r0 = std::clamp((-b + std::sqrt(root2)) / a, 0.0, f.radius),
                 r1 = std::clamp((-b - std::sqrt(root2)) / a, 0.0, f.radius);
    covered += r1 * r1 - r0 * r0;
  }
  return 1.0 - covered / (k_steps * f.radius * f.radius);
}

TEST(closed_form, a_partly_hidden_sun_behind_a_sphere_is_exact_to_a_millionth) {
  const Light light = sun({0, -1, 0.4}, 3.0);
  const SphereOccluder sphere{{0, 1.5, 0}, 0.5};
  int partial = 0;
  for (int i = 0; i < 12; ++i) {
    const dvec3 point(0.38 + 0.015 * i, 0, 0.55);
    const double visible = closed_form_visibility(point, light, sphere).value();
    if (visible <= 0.0 || visible >= 1.0) continue;
    EXPECT_NEAR(visible, sphere_by_quadrature(point, light, sphere), 1e-6) << i;
    ++partial;
  }
  EXPECT_GE(partial, 3);
}

TEST(closed_form, a_polygon_over_the_whole_disc_covers_it) {
  const dvec2 square[] = {{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}};
  EXPECT_NEAR(disc_polygon_overlap(square, 0.5), 0.25 * k_pi_d, 1e-12);
  const dvec2 quadrant[] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  EXPECT_NEAR(disc_polygon_overlap(quadrant, 2.0), k_pi_d, 1e-12);
  const dvec2 inside[] = {{-0.1, 0}, {0, -0.1}, {0.1, 0}, {0, 0.1}};
  EXPECT_NEAR(disc_polygon_overlap(inside, 2.0), 0.02, 1e-15);
  const dvec2 aside[] = {{3, -1}, {4, -1}, {4, 5}, {3, 5}};
  EXPECT_NEAR(disc_polygon_overlap(aside, 2.0), 0.0, 1e-15);
}

TEST(closed_form, there_is_no_answer_below_the_horizon_or_for_other_lights) {
  const SphereOccluder sphere{{0, 1.0, 0}, 0.5};
  EXPECT_FALSE(closed_form_visibility({0, 0, 0}, sun({1, -0.01, 0}, 3.0), sphere).has_value());
  EXPECT_TRUE(closed_form_visibility({0, 0, 0}, sun({1, -0.01, 0}, 0.0), sphere).has_value());
  EXPECT_FALSE(closed_form_visibility({0, 0, 0}, sun({1, 0.2, 0}, 0.0), sphere).has_value());
  EXPECT_FALSE(closed_form_visibility({0, 0.9, 0}, sun(k_slanted, 0.0), sphere).has_value());  // inside the caster
  Light lamp;
  lamp.kind = LightKind::point;
  EXPECT_FALSE(closed_form_visibility({0, 0, 0}, lamp, sphere).has_value());
}

}  // namespace
}  // namespace gnomon
