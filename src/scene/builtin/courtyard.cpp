// courtyard: rough first version.
#include "scene/builtin/builtin.h"
#include "scene/builtin/noise.h"
#include "scene/builtin/shapes.h"

namespace gnomon {

Scene make_courtyard(const BuiltinOptions&) {
  Scene scene;
  scene.name = "courtyard";
  Material stone;
  stone.name = "stone", stone.base_colour = vec4(0.6f, 0.5f, 0.38f, 1.0f);
  const int m = add_material(scene, stone);
  MeshPart ground = part_of(m);
  add_surface(ground, {40, 40, false, false, {12, 12}}, [](double u, double v) {
    const glm::dvec3 p(24 * (u - 0.5), 0, 24 * (0.5 - v));
    return glm::dvec3(p.x, 0.06 * (noise(p * 0.5, 1) - 0.5), p.z);
  });
  add_object(scene, "ground", add_mesh(scene, "ground", {ground}));
  MeshPart column = part_of(m);
  const std::vector<vec2> profile = {{0.3f, -0.1f}, {0.3f, 0.1f}, {0.22f, 0.15f}, {0.18f, 2.6f}, {0.28f, 2.7f}, {0.28f, 2.85f}, {0, 2.85f}};
  add_lathe(column, profile, 24, {2, 2});
  const int column_mesh = add_mesh(scene, "column", {column});
  for (int i = 0; i < 6; ++i) add_object(scene, "column", column_mesh, translation({-6.0f + 2.2f * static_cast<float>(i), 0, -5}));
  MeshPart beam = part_of(m);
  add_box(beam, {-6.5f, 2.85f, -5.3f}, {5.5f, 3.6f, -4.7f}, 0.5f);
  add_object(scene, "beam", add_mesh(scene, "beam", {beam}));
  MeshPart wall = part_of(m);
  add_box(wall, {7, -0.2f, -6}, {7.5f, 4, 8}, 0.5f);
  add_object(scene, "wall", add_mesh(scene, "wall", {wall}));
  MeshPart ball = part_of(m);
  add_sphere(ball, {0.5f, 0.45f, 1.5f}, 0.45f, 32, 16, {2, 1});
  add_object(scene, "ball", add_mesh(scene, "ball", {ball}));
  Light sun;
  sun.name = "sun", sun.direction = glm::normalize(vec3(0.80f, -0.50f, 0.36f)), sun.colour = vec3(1.0f, 0.86f, 0.68f), sun.intensity = 3.0f;
  sun.angular_diameter = static_cast<float>(radians_of(0.533));
  scene.lights.push_back(sun);
  scene.cameras.push_back(look_at("default", {-6.2f, 1.65f, 7.5f}, {0.8f, 1.3f, -1.5f}, 55.0));
  scene.cameras.push_back(look_at("detail", {-3.5f, 1.0f, 4.0f}, {0.5f, 0.4f, 1.5f}, 40.0));
  return scene;
}

}  // namespace gnomon
