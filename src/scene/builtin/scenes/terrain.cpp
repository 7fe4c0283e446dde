// terrain: a height map of 135 x 135 vertices and one model of 1.3 million, the load of published measurements (with maps of
// 2048 x 2048 texels and a view of 800 x 600). The model is a torus knot, carved in spirals and weathered, on a plinth.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/procedural_textures.h"
#include "scene/builtin/parts/shapes.h"
#include "scene/path.h"

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double k_turn = 6.28318530717958647693;
constexpr int k_terrain_side = 135;  // vertices
constexpr double k_terrain_m = 90.0;
constexpr int k_around = 2048, k_across = 640;  // of the knot at detail 1: 2049 x 641 vertices, since texture seams are doubled

double square(double value) { return value * value; }

// Hills that rise outward from a level place in the middle.
double terrain_height(double x, double z) {
  const double distance = std::sqrt(x * x + z * z);
  const double outward = smooth_step(5.0f, 26.0f, static_cast<float>(distance));
  const double ridge = 1.0 - std::abs(2.0 * fractal({0.045 * x, 0.5, 0.045 * z}, 4, 11) - 1.0);
  const double rolling = 0.5 * (fractal({0.25 * x, 2.5, 0.25 * z}, 3, 17) - 0.5);
  return outward * (7.5 * square(ridge) - 2.5 + 0.10 * std::max(0.0, distance - 20.0)) + rolling * (0.15 + 0.85 * outward);
}

// Centre line of a (2, 3) torus knot.
constexpr double k_ring = 1.9, k_tube = 0.95;
dvec3 knot(double t) {
  const dvec2 around = unit_circle(2.0 * t), lift = unit_circle(3.0 * t);
  const double r = k_ring + k_tube * lift.x;
  return {r * around.x, r * around.y, k_tube * lift.y};
}

// Point of the sculpture's surface for u along and v around the tube, both of period 1. The frame comes from the torus that
// carries the knot, so that it closes.
dvec3 sculpture(double u, double v) {
  const double t = k_turn * u;
  const dvec3 centre = knot(t), along = glm::normalize(knot(t + 1e-4) - knot(t - 1e-4));
  const dvec2 around = unit_circle(2.0 * t);
  const dvec3 from_ring = centre - k_ring * dvec3(around, 0.0);
  const dvec3 normal = glm::normalize(from_ring - along * glm::dot(from_ring, along)), binormal = glm::cross(along, normal);
  const dvec2 turn = unit_circle(-k_turn * v);  // this way round, dP/du x dP/dv points outward
  const dvec3 out = turn.x * normal + turn.y * binormal;
  const dvec3 smooth = centre + 0.5 * out;
  const double flute = std::abs(sine(k_turn * (3.0 * v + 7.0 * u)));  // six spiral ridges
  const double weather = fractal(2.2 * smooth, 4, 41) - 0.5, chisel = noise(26.0 * smooth, 47) - 0.5;
  return centre + (0.42 + 0.12 * flute + 0.16 * weather + 0.012 * chisel) * out;
}

SurfaceGrid sculpture_grid(double detail) {
  const auto scaled = [scale = std::sqrt(detail)](int count) { return std::max(12, static_cast<int>(count * scale + 0.5)); };
  return {scaled(k_around), scaled(k_across), true, true, {18, 3}};
}

}  // namespace

static Scene make_terrain(const BuiltinOptions& options) {
  Scene scene;
  scene.name = "terrain";
  MeshPart ground = part_of(add_material(scene, textured_material(scene, "soil", soil_texture(512))));
  add_surface(ground, {k_terrain_side - 1, k_terrain_side - 1, false, false, {22, 22}}, [](double u, double v) {
    const double x = k_terrain_m * (u - 0.5), z = k_terrain_m * (0.5 - v);
    return dvec3(x, terrain_height(x, z), z);
  });
  add_object(scene, "terrain", add_mesh(scene, "terrain", {ground}));

  MeshPart model = part_of(add_material(
      scene, shiny(textured_material(scene, "marble", limestone_texture(256), {0.95f, 0.90f, 0.84f}), 0.15f, 32.0f)));
  add_surface(model, sculpture_grid(options.at("detail")), sculpture);
  add_object(scene, "sculpture", add_mesh(scene, "sculpture", {std::move(model)}),
             translation({0, 5.22f, 0}) * rotation({0, 1, 0}, radians_of(-28.0)) * rotation({0, 0, 1}, radians_of(30.0)));

  MeshPart plinth = part_of(add_material(scene, textured_material(scene, "plinth", masonry_texture(512))));
  add_box(plinth, {-1.5f, -0.6f, -1.5f}, {1.5f, 0.45f, 1.5f}, 0.5f);
  add_box(plinth, {-1.1f, 0.45f, -1.1f}, {1.1f, 1.75f, 1.1f}, 0.5f);
  add_box(plinth, {-1.25f, 1.75f, -1.25f}, {1.25f, 1.95f, 1.25f}, 0.5f);
  add_object(scene, "plinth", add_mesh(scene, "plinth", {plinth}));

  scene.lights.push_back(sun_light("sun", vec3(0.72f, -0.50f, -0.22f), vec3(1.0f, 0.92f, 0.80f), 3.0f));
  scene.cameras.push_back(look_at("default", {-2.5f, 4.2f, 17.0f}, {2.0f, 3.3f, 0.0f}, 45.0));
  const std::vector<CameraPose> walk = {{{-2.5f, 4.2f, 17.0f}, {2.0f, 3.3f, 0.0f}},
                                        {{-9.0f, 4.0f, 11.5f}, {0.0f, 4.0f, 0.0f}},
                                        {{-12.0f, 4.2f, 3.0f}, {0.0f, 4.5f, 0.0f}},
                                        {{-9.0f, 4.0f, -5.0f}, {0.0f, 4.5f, 0.0f}}};
  const std::vector<CameraPose> fly = {{{0.0f, 20.0f, 34.0f}, {0.0f, 3.0f, 0.0f}},
                                       {{-28.0f, 18.0f, 18.0f}, {0.0f, 3.0f, 0.0f}},
                                       {{-30.0f, 16.0f, -14.0f}, {0.0f, 3.0f, 0.0f}},
                                       {{2.0f, 20.0f, -30.0f}, {0.0f, 3.0f, 0.0f}}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_terrain() {
  return {"terrain",
          "A height map of 135 x 135 vertices and a sculpture of 1.3 million.",
          {{"detail", 1.0, 0.001, 4.0, "Vertices of the sculpture as a fraction of 1.3 million"}},
          make_terrain};
}

}  // namespace gnomon
