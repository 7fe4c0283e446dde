// terrain: a height map and one dense model, the scene of published measurements (maps of 2048 texels, view of 800 x 600).
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/shapes.h"

namespace gnomon {
namespace {

constexpr int k_terrain_side = 135;  // vertices

double terrain_height(double x, double z) { return 6.0 * (fractal({x * 0.06, 0.0, z * 0.06}, 5, 11) - 0.5); }

}  // namespace

Scene make_terrain(const BuiltinOptions& options) {
  const double scale = std::sqrt(options.at("detail"));
  Scene scene;
  scene.name = "terrain";
  Material soil;
  soil.name = "soil", soil.base_colour = vec4(0.3f, 0.28f, 0.15f, 1.0f);
  MeshPart ground = part_of(add_material(scene, soil));
  add_surface(ground, {k_terrain_side - 1, k_terrain_side - 1, false, false, {30, 30}}, [](double u, double v) {
    const double x = 60 * (u - 0.5), z = 60 * (0.5 - v);
    return glm::dvec3(x, terrain_height(x, z), z);
  });
  add_object(scene, "terrain", add_mesh(scene, "terrain", {ground}));
  Material bronze;
  bronze.name = "bronze", bronze.base_colour = vec4(0.5f, 0.3f, 0.15f, 1.0f);
  MeshPart model = part_of(add_material(scene, bronze));
  const int columns = std::max(8, static_cast<int>(1280 * scale)), rows = std::max(8, static_cast<int>(1024 * scale));
  add_sphere(model, {0, 4, 0}, 2.5f, columns, rows, {4, 2});
  add_object(scene, "model", add_mesh(scene, "model", {model}));
  Light sun;
  sun.name = "sun", sun.direction = glm::normalize(vec3(0.7f, -0.55f, 0.25f)), sun.intensity = 3.0f;
  sun.angular_diameter = static_cast<float>(radians_of(0.533));
  scene.lights.push_back(sun);
  scene.cameras.push_back(look_at("default", {-6, 6, 16}, {0.5f, 2.5f, 0}, 45.0));
  return scene;
}

}  // namespace gnomon
