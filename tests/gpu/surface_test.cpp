// The surface buffer against geometry that can be written down: planes, a sphere, edges through known sample positions.
#include <cmath>

#include "frame/glsl/octahedral.glsl"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::device;
using test::View;

constexpr uvec2 k_size = {64, 48};

// Vulkan 1.3, "Standard sample locations", in sixteenths.
std::vector<dvec2> sample_positions(uint32_t samples) {
  if (samples == 2) return {dvec2(12, 12) / 16.0, dvec2(4, 4) / 16.0};
  if (samples == 4) return {dvec2(6, 2) / 16.0, dvec2(14, 6) / 16.0, dvec2(2, 10) / 16.0, dvec2(10, 14) / 16.0};
  if (samples == 8) {
    return {dvec2(9, 5) / 16.0,  dvec2(7, 11) / 16.0, dvec2(13, 9) / 16.0,  dvec2(5, 3) / 16.0,
            dvec2(3, 13) / 16.0, dvec2(1, 7) / 16.0,  dvec2(11, 15) / 16.0, dvec2(15, 1) / 16.0};
  }
  return {dvec2(0.5)};
}

struct Ray {
  dvec3 origin, direction, forward;
};

// Written from the scene's camera, not from what the shaders read.
Ray camera_ray(const Camera& camera, const dvec2& pixel) {
  const glm::dmat4 pose(camera.world_from_view);
  const dvec2 ndc(pixel.x / k_size.x * 2.0 - 1.0, 1.0 - pixel.y / k_size.y * 2.0);
  const double aspect = double(k_size.x) / k_size.y;
  const dvec3 right(pose[0]), up(pose[1]), forward = -dvec3(pose[2]), eye(pose[3]);
  if (camera.orthographic) {
    const double half = double(camera.half_height);
    return {eye + right * (ndc.x * aspect * half) + up * (ndc.y * half), forward, forward};
  }
  const double slope = std::tan(0.5 * double(camera.vertical_fov));
  return {eye, glm::normalize(forward + right * (ndc.x * aspect * slope) + up * (ndc.y * slope)), forward};
}

template <class Visit>  // visit(index, ray, pixel, sample)
void for_each_sample(const Camera& camera, uint32_t samples, const Visit& visit) {
  const auto positions = sample_positions(samples);
  size_t index = 0;
  for (uint32_t y = 0; y < k_size.y; ++y) {
    for (uint32_t x = 0; x < k_size.x; ++x) {
      for (uint32_t s = 0; s < samples; ++s, ++index)
        visit(index, camera_ray(camera, dvec2(x, y) + positions[s]), y * k_size.x + x, s);
    }
  }
}

std::vector<uint32_t> offered_samples() { return {device().info().sample_counts.begin(), device().info().sample_counts.end()}; }

Scene floor_scene(bool orthographic) {
  Scene scene = test::scene_with({test::floor_part(100.0f)});
  scene.cameras.push_back(look_at("slanted", {1, 2, 3}, {0.3f, 0, -2}, 60.0));
  scene.cameras[0].orthographic = orthographic;
  scene.cameras[0].half_height = 3.0f;
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  return scene;
}

TEST(Surface, PlaneIsWhereItIs) {
  for (const bool orthographic : {false, true}) {
    for (const uint32_t samples : offered_samples()) {
      View view(floor_scene(orthographic), k_size, samples);
      view.draw();
      const auto points = view.frame().read_points();
      const auto view_z = test::read_surface<float>(view, "surface view_z");
      const auto normals = test::read_surface<uint32_t>(view, "surface normal");
      double worst_z = 0.0, worst_height = 0.0;
      size_t seen = 0;
      for_each_sample(view.scene().cameras[0], samples, [&](size_t i, const Ray& ray, uint32_t pixel, uint32_t) {
        EXPECT_EQ(points[i].pixel, pixel);
        const double distance = -ray.origin.y / ray.direction.y;
        const dvec3 expected = ray.origin + distance * ray.direction;
        const bool hit = distance > 0.1 && std::abs(expected.x) < 99.0 && std::abs(expected.z) < 99.0;
        if (!hit) return;
        ++seen;
        ASSERT_EQ(points[i].object, 0u);
        const double z = distance * glm::dot(ray.direction, ray.forward);
        worst_z = std::max(worst_z, std::abs(double(view_z[i]) - z) / z);
        const dvec3 p(points[i].position_ws);
        worst_height = std::max(worst_height, std::abs(p.y) / std::max({std::abs(p.x), std::abs(p.z), 1.0}));
        EXPECT_EQ(unpack_normal(normals[i]), vec3(0, 1, 0));
      });
      EXPECT_GT(seen, points.size() / 2);
      const std::string what = fmt::format("{} samples{}", samples, orthographic ? ", orthographic" : "");
      EXPECT_LT(worst_z, 1e-5) << what;
      // What rays rely on (base/glsl/sampling.glsl, ray_origin): half of the 2^-19 of the largest coordinate that they start
      // above.
      EXPECT_LT(worst_height, std::ldexp(1.0, -20)) << what;
    }
  }
}

Scene sphere_scene() {
  MeshPart sphere = part_of(0);
  add_sphere(sphere, {0, 1, 0}, 1.0f, 256, 128, {1, 1});
  Scene scene = test::scene_with({std::move(sphere)});
  scene.cameras.push_back(look_at("near", {1, 2, 3}, {0, 1, 0}, 50.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  return scene;
}

// Distance along the ray, or negative.
double hit_sphere(const Ray& ray, const dvec3& centre, double radius) {
  const dvec3 to_centre = centre - ray.origin;
  const double along = glm::dot(to_centre, ray.direction), across2 = glm::dot(to_centre, to_centre) - along * along;
  return across2 > radius * radius ? -1.0 : along - std::sqrt(radius * radius - across2);
}

TEST(Surface, SphereIsWhereItIsAndSkyIsSky) {
  const dvec3 centre(0, 1, 0);
  for (const uint32_t samples : offered_samples()) {
    View view(sphere_scene(), k_size, samples);
    view.draw();
    const auto points = view.frame().read_points();
    const auto items = test::read_surface<uint32_t>(view, "surface item");
    const auto view_z = test::read_surface<float>(view, "surface view_z");
    size_t wrong_coverage = 0, seen = 0;
    double worst_radius = 0.0, worst_normal = 1.0;
    for_each_sample(view.scene().cameras[0], samples, [&](size_t i, const Ray& ray, uint32_t, uint32_t) {
      const bool drawn = points[i].object != k_no_object;
      EXPECT_EQ(drawn, items[i] != 0xffffffffu);
      EXPECT_EQ(drawn, view_z[i] > 0.0f);
      wrong_coverage += drawn != (hit_sphere(ray, centre, 1.0) > 0.0);
      if (!drawn) return;
      ++seen;
      const dvec3 out = dvec3(points[i].position_ws) - centre;
      worst_radius = std::max(worst_radius, std::abs(glm::length(out) - 1.0));
      worst_normal = std::min(worst_normal, glm::dot(glm::normalize(out), dvec3(points[i].geometric_normal_ws)));
    });
    EXPECT_GT(seen, points.size() / 8);
    // The flat triangles of 256 x 128: sagitta 3e-4 of the radius, half a triangle's angle 1.2 degrees at most.
    EXPECT_LE(wrong_coverage, 2 * samples) << samples << " samples";
    EXPECT_LT(worst_radius, 4e-4);
    EXPECT_GT(worst_normal, std::cos(1.3 * glm::pi<double>() / 180.0));
  }
}

// A quad that stands upright before the sky, its edges slanted in the picture.
Scene slanted_quad() {
  MeshPart part = part_of(0);
  const float c = std::cos(0.35f), s = std::sin(0.35f);
  const vec3 u(c, s, 0), v(-s, c, 0);
  add_quad(part, -u - v, u - v, u + v, -u + v, {0, 0}, {1, 1});
  Scene scene = test::scene_with({std::move(part)});
  scene.cameras.push_back(look_at("front", {0, 0, 4}, {0, 0, 0}, 50.0));
  scene.lights.push_back(test::make_sun({0, -1, -1}));
  return scene;
}

TEST(Surface, SamplesLieAtTheStandardPositions) {
  for (const uint32_t samples : offered_samples()) {
    View view(slanted_quad(), k_size, samples);
    view.draw();
    const auto items = test::read_surface<uint32_t>(view, "surface item");
    const double c = std::cos(0.35), s = std::sin(0.35);
    const double metres_per_pixel = 2.0 * 4.0 * std::tan(25.0 * glm::pi<double>() / 180.0) / k_size.y;
    size_t checked = 0, wrong = 0;
    for_each_sample(view.scene().cameras[0], samples, [&](size_t i, const Ray& ray, uint32_t, uint32_t) {
      const dvec3 p = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
      const double inside =
          1.0 - std::max(std::abs(c * p.x + s * p.y), std::abs(-s * p.x + c * p.y));  // metres from the border
      if (std::abs(inside) < metres_per_pixel / 64.0) return;                         // the rasteriser's grid is 1/256 pixel
      ++checked;
      wrong += (items[i] != 0xffffffffu) != (inside > 0.0);
    });
    EXPECT_GT(checked, items.size() * 9 / 10);
    EXPECT_EQ(wrong, 0u) << samples << " samples";
  }
}

TEST(Surface, SamplesOfOneSurfaceShareAndEdgesDoNot) {
  for (const uint32_t samples : offered_samples()) {
    View plane(floor_scene(false), k_size, samples);
    plane.draw();
    for (const uint32_t share : test::read_surface<uint32_t>(plane, "surface share")) {
      // The floor's two triangles are one surface, and so is the sky. The floor's end against the sky is the exception.
      for (uint32_t s = 0; s < samples; ++s) EXPECT_LE((share >> (4 * s)) & 15u, s);
    }
    View quad(slanted_quad(), k_size, samples);
    quad.draw();
    const auto items = test::read_surface<uint32_t>(quad, "surface item");
    const auto shares = test::read_surface<uint32_t>(quad, "surface share");
    size_t edges = 0;
    for (size_t pixel = 0; pixel < shares.size(); ++pixel) {
      uint32_t expected = 0;
      bool edge = false;
      for (uint32_t s = 0; s < samples; ++s) {
        uint32_t leader = 0;
        while (items[pixel * samples + leader] != items[pixel * samples + s]) ++leader;
        expected |= leader << (4 * s);
        edge |= leader > 0;
      }
      edges += edge;
      ASSERT_EQ(shares[pixel], expected) << "pixel " << pixel << ", " << samples << " samples";
    }
    if (samples > 1) {
      EXPECT_GT(edges, 40u);
    }
  }
}

TEST(Surface, ACreaseDoesNotShare) {
  // Two faces of one item meet in the middle of the picture: at a right angle, and at a tenth of one.
  MeshPart roof = part_of(0);
  const float drop = std::tan(0.5f * 0.1f * k_pi / 2.0f);
  add_quad(roof, {-1, -drop, 1}, {0, 0, 1}, {0, 0, -1}, {-1, -drop, -1}, {0, 0}, {1, 1});
  add_quad(roof, {0, 0, 1}, {1, -drop, 1}, {1, -drop, -1}, {0, 0, -1}, {0, 0}, {1, 1});
  Scene box = test::scene_with({test::box_part({-1, -1, -1}, {1, 1, 1})}), low_roof = test::scene_with({roof});
  box.cameras.push_back(look_at("corner", {3.1f, 1.4f, 2.2f}, {0, 0, 0}, 40.0));
  low_roof.cameras.push_back(look_at("ridge", {0.7f, 3.1f, 1.9f}, {0, 0, 0}, 40.0));
  std::vector<std::pair<Scene, uint32_t>> cases;
  for (const uint32_t samples : offered_samples()) {
    if (samples > 1) cases.insert(cases.end(), {{box, samples}, {low_roof, samples}});
  }
  for (auto& [scene, samples] : cases) {
    scene.lights.push_back(test::make_sun({0, -1, -1}));
    View view(scene, k_size, samples);
    view.draw();
    const auto normals = test::read_surface<uint32_t>(view, "surface normal");
    const auto items = test::read_surface<uint32_t>(view, "surface item");
    const auto shares = test::read_surface<uint32_t>(view, "surface share");
    size_t creases = 0;
    for (size_t i = 0; i < normals.size(); ++i) {
      const size_t first = i / samples * samples;
      if (items[i] == 0xffffffffu || items[first] == 0xffffffffu) continue;
      const uint32_t leader = (shares[i / samples] >> (4 * (i - first))) & 15u;
      EXPECT_EQ(normals[first + leader], normals[i]);
      creases += normals[first] != normals[i];
    }
    EXPECT_GT(creases, 10u);
  }
}

TEST(Surface, MirroredAndDoubleSidedObjectsAreSeenFromTheRightSide) {
  MeshPart quad = part_of(0);
  add_quad(quad, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0}, {1, 1});  // faces +Z
  const auto middle = [&](const mat4& transform, bool double_sided, float eye_z) {
    Scene scene = test::scene_with({quad});
    scene.materials[0].double_sided = double_sided;
    scene.objects[0].world_from_object = transform;
    scene.cameras.push_back(look_at("eye", {0, 0, eye_z}, {0, 0, 0}, 40.0));
    scene.lights.push_back(test::make_sun({0, 0, -eye_z}));
    View view(std::move(scene), k_size);
    view.draw();
    const SurfacePoint point = view.frame().read_points()[k_size.y / 2 * k_size.x + k_size.x / 2];
    if (point.object == k_no_object) return std::string("sky");
    return std::string(point.geometric_normal_ws.z * eye_z > 0.0f ? "toward" : "away");
  };
  const mat4 plain(1.0f), mirrored_x = glm::scale(mat4(1.0f), vec3(-1, 1, 1)),
                          mirrored_z = glm::scale(mat4(1.0f), vec3(1, 1, -1));
  EXPECT_EQ(middle(plain, false, 3.0f), "toward");
  EXPECT_EQ(middle(plain, false, -3.0f), "sky") << "a back face was drawn";
  EXPECT_EQ(middle(plain, true, -3.0f), "toward") << "the normal must turn toward the viewer";
  // A mirror image across x keeps its front where it was; across z the front changes sides.
  EXPECT_EQ(middle(mirrored_x, false, 3.0f), "toward");
  EXPECT_EQ(middle(mirrored_x, false, -3.0f), "sky");
  EXPECT_EQ(middle(mirrored_z, false, 3.0f), "sky");
  EXPECT_EQ(middle(mirrored_z, false, -3.0f), "toward");
  EXPECT_EQ(middle(mirrored_x, true, -3.0f), "toward");
}

}  // namespace
}  // namespace gnomon
