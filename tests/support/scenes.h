// Small scenes for the tests that need a device. Materials: 0 grey, single-sided.
#pragma once

#include "scene/builtin/parts/shapes.h"
#include "scene/load.h"

namespace gnomon::test {

inline Scene scene_with(std::vector<MeshPart> parts) {
  Scene scene;
  scene.name = "hand-made";
  Material grey;
  grey.base_colour = vec4(0.6f, 0.6f, 0.6f, 1.0f);
  add_material(scene, grey);
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string name = "part " + std::to_string(i);
    add_object(scene, name, add_mesh(scene, name, {std::move(parts[i])}));
  }
  return scene;
}

inline MeshPart box_part(const vec3& min, const vec3& max) {
  MeshPart part = part_of(0);
  add_box(part, min, max, 1.0f);
  return part;
}

// In the plane y = height, facing up.
inline MeshPart floor_part(float half, float height = 0.0f) {
  MeshPart part = part_of(0);
  add_quad(part, {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}, {0, 0}, {1, 1});
  return part;
}

inline Light make_sun(const vec3& direction, float angular_diameter = 0.0f) {
  Light light;
  light.name = "sun";
  light.direction = glm::normalize(direction);
  light.angular_diameter = angular_diameter;
  light.intensity = 3.0f;
  return light;
}

}  // namespace gnomon::test
