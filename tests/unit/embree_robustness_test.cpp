// Ray origins at work: no surface shadows itself, and no shadow leaves its caster, at any distance from the origin.
#include <gtest/gtest.h>

#include <random>

#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"

namespace gnomon {
namespace {

using namespace test;
using glm::dvec3;

// Random points on a mesh with the errors that a surface buffer has: the position's rounding, and the rasteriser's vertex grid.
std::vector<SurfacePoint> points_on(const MeshPart& part, const dvec3& eye, size_t count) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> unit(0.0, 1.0), error(-1.0, 1.0);
  std::vector<SurfacePoint> points;
  while (points.size() < count) {
    const size_t triangle = random() % part.triangle_count() * 3;
    const dvec3 a(part.positions[part.indices[triangle]]), b(part.positions[part.indices[triangle + 1]]);
    const dvec3 c(part.positions[part.indices[triangle + 2]]);
    const dvec3 cross = glm::cross(b - a, c - a);
    if (glm::length(cross) == 0.0) continue;
    const dvec3 normal = glm::normalize(cross);
    double u = unit(random), v = unit(random);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const dvec3 exact = a + u * (b - a) + v * (c - a);
    const double distance = glm::distance(exact, eye);
    const dvec3 sizes = glm::abs(exact);
    const double largest = std::max({1.0, distance, sizes.x, sizes.y, sizes.z});
    const double noise = error(random) * 10.0 * 0x1p-24 * largest + error(random) * 3.8e-6 * distance;
    points.push_back({vec3(exact + normal * noise), 0, vec3(normal), static_cast<uint32_t>(points.size())});
  }
  return points;
}

// Share of receivers that are not fully lit.
double shadowed_share(const EmbreeReference& reference, std::span<const SurfacePoint> points, const dvec3& eye,
                      const Light& light, bool area) {
  const ReferenceResult result = reference.trace(points, vec3(eye), light, area, 16, 1);
  size_t receivers = 0, shadowed = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    receivers += result.receiver[i];
    shadowed += result.receiver[i] && result.visibility[i] < 1.0f ? 1 : 0;
  }
  EXPECT_GT(receivers, points.size() / 100);
  return static_cast<double>(shadowed) / static_cast<double>(receivers);
}

const dvec3 k_places[] = {dvec3(0), dvec3(1000, -300, 700), dvec3(10000, 0, 10000)};

TEST(EmbreeRobustness, AClosedSphereDoesNotShadowItself) {
  for (const dvec3& place : k_places) {
    Scene scene = empty_scene();
    add(scene, grid(128, 64, [&](double u, double v) {
          const double theta = glm::pi<double>() * v, phi = 2.0 * glm::pi<double>() * u;
          return place + 3.0 * dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
        }));
    const dvec3 eye = place + dvec3(0, 2, 8);
    const EmbreeReference reference(scene);
    const auto points = points_on(scene.meshes[0].parts[0], eye, 100000);
    EXPECT_EQ(shadowed_share(reference, points, eye, sun({0.3f, -1, 0.2f}), false), 0.0) << place.x;
    EXPECT_EQ(shadowed_share(reference, points, eye, sun({-1, -0.1f, 0.2f}), false), 0.0) << place.x;
  }
}

TEST(EmbreeRobustness, ATiltedPlaneOfManyTrianglesDoesNotShadowItself) {
  for (const dvec3& place : k_places) {
    Scene scene = empty_scene();
    add(scene, grid(224, 224, [&](double u, double v) {  // 100 352 triangles
          return place + dvec3(100.0 * (u - 0.5), 20.0 * (u - 0.5) + 10.0 * (v - 0.5), 100.0 * (v - 0.5));
        }));
    const dvec3 normal = glm::normalize(dvec3(-0.2, 1, -0.1)), eye = place + 2.0 * normal;
    const EmbreeReference reference(scene);
    const auto points = points_on(scene.meshes[0].parts[0], eye, 15000);
    const dvec3 along = glm::normalize(glm::cross(normal, dvec3(0.3, 0, 1)));
    for (const double elevation : {0.003, 0.03, 0.3}) {
      const Light light = sun(vec3(-std::sin(elevation) * normal - std::cos(elevation) * along), 0.01f);
      EXPECT_EQ(shadowed_share(reference, points, eye, light, false), 0.0) << place.x << ' ' << elevation;
      // Far from the origin rounded vertices make the plane rough, and the lowest rays of the sun's disc do meet that.
      EXPECT_LE(shadowed_share(reference, points, eye, light, true), place.x > 0.0 ? 0.01 : 0.0) << place.x << ' ' << elevation;
    }
  }
}

TEST(EmbreeRobustness, ALargeTiltedQuadDoesNotShadowItself) {
  for (const float half : {10.0f, 100.0f, 1000.0f}) {
    Scene scene = empty_scene();
    const dvec3 normal = glm::normalize(dvec3(-0.4, 1, -0.3));
    const dvec3 u = glm::normalize(glm::cross(normal, dvec3(1, 2, 3))), v = glm::cross(normal, u);
    add(scene, quad(vec3(0), half * vec3(u), half * vec3(v)));
    const dvec3 eye = 0.3 * normal;
    // Near the eye, where the offset that grows with its distance is smallest.
    const EmbreeReference reference(scene);
    const MeshPart near = quad(vec3(0), vec3(u), vec3(v));
    const auto points = points_on(near, eye, 100000);
    const Light light = sun(-vec3(normal * 0.01 + u));
    EXPECT_EQ(shadowed_share(reference, points, eye, light, false), 0.0) << half;
  }
}

// Hit test in doubles, on the mesh as it is: the independent answer for a terrain.
bool hits(const MeshPart& part, const dvec3& origin, const dvec3& direction) {
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    const dvec3 a(part.positions[part.indices[i]]), b(part.positions[part.indices[i + 1]]),
        c(part.positions[part.indices[i + 2]]);
    const dvec3 p = glm::cross(direction, c - a);
    const double determinant = glm::dot(b - a, p);
    const dvec3 s = origin - a;
    const double u = glm::dot(s, p) / determinant;
    if (!(u >= 0.0 && u <= 1.0)) continue;
    const dvec3 q = glm::cross(s, b - a);
    const double v = glm::dot(direction, q) / determinant;
    if (v >= 0.0 && u + v <= 1.0 && glm::dot(c - a, q) / determinant > 0.0) return true;
  }
  return false;
}

TEST(EmbreeRobustness, ATerrainAtGrazingSunAgreesWithDoubles) {
  for (const dvec3& place : {k_places[0], k_places[1]}) {
    Scene scene = empty_scene();
    add(scene, grid(224, 224, [&](double u, double v) {
          const double x = 100.0 * (u - 0.5), z = 100.0 * (v - 0.5);
          return place + dvec3(x, 1.5 * std::sin(0.31 * x) * std::cos(0.27 * z) + 0.05 * std::sin(3.1 * x + 2.3 * z), z);
        }));
    const MeshPart& part = scene.meshes[0].parts[0];
    const dvec3 eye = place + dvec3(0, 5, 0);
    const auto points = points_on(part, eye, 400);
    const Light light = sun({-1, -0.1f, -0.3f});
    const ReferenceResult result = EmbreeReference(scene).trace(points, vec3(eye), light, false, 1, 1);
    size_t receivers = 0, shadowed = 0, wrong = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      if (!result.receiver[i]) continue;
      // As little above the surface as the point's own error allows.
      const double lift =
          30.0 * 0x1p-24 * (glm::length(place) + 10.0) + 8.0e-6 * glm::distance(dvec3(points[i].position_ws), eye);
      const dvec3 origin = dvec3(points[i].position_ws) + lift * dvec3(points[i].geometric_normal_ws);
      const bool truth = hits(part, origin, -dvec3(light.direction));
      ++receivers, shadowed += truth ? 1 : 0, wrong += truth != (result.visibility[i] == 0.0f) ? 1 : 0;
    }
    EXPECT_GT(shadowed, receivers / 10);
    EXPECT_LT(shadowed, receivers - receivers / 10);
    EXPECT_LE(wrong, 1u) << "of " << receivers << " at " << place.x;
  }
}

TEST(EmbreeRobustness, ShadowsTouchTheirCasters) {
  Scene scene = empty_scene();
  add(scene, floor_quad(10.0f));
  add(scene, box(vec3(-1, 0, -1), vec3(1, 2, 1)));
  add(scene, quad({5, 1.5e-4f, 0}, {0, 0, 1}, {1, 0, 0}));  // a sheet that hovers 0.15 mm over the floor
  const Light light = sun({1, -1, 0});
  const vec3 eye(0, 6, 8);  // 10 m away
  const std::vector<SurfacePoint> points = {floor_point(1.00002f, 0), floor_point(1.01f, 0.99f), floor_point(-1.00002f, 0),
                                            floor_point(5, 0)};
  const ReferenceResult result = EmbreeReference(scene).trace(points, eye, light, false, 1, 1);
  EXPECT_EQ(result.visibility, (std::vector<float>{0, 0, 1, 0}));
}

}  // namespace
}  // namespace gnomon
