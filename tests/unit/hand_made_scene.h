// Small scenes whose shadows are known, and points on them, for the tests of the reference.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene/scene.h"
#include "scene/surface_point.h"

namespace gnomon::test {

// Parallelogram around `centre`; its front faces cross(u, v). uv runs from (0,0) to (1,1) along u and v.
inline MeshPart quad(const vec3& centre, const vec3& half_u, const vec3& half_v) {
  MeshPart part;
  part.positions = {centre - half_u - half_v, centre + half_u - half_v, centre - half_u + half_v, centre + half_u + half_v};
  part.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  part.indices = {0, 1, 2, 2, 1, 3};
  return part;
}

// Horizontal, facing up.
inline MeshPart floor_quad(float half, float height = 0.0f) { return quad({0, height, 0}, {0, 0, half}, {half, 0, 0}); }

inline MeshPart box(const vec3& low, const vec3& high) {
  MeshPart part;
  const Box bounds{low, high};
  for (int i = 0; i < 8; ++i) part.positions.push_back(bounds.corner(i));
  part.indices = {0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6};
  return part;
}

// A (columns + 1) x (rows + 1) grid of points place(u, v), u and v in [0, 1].
inline MeshPart grid(uint32_t columns, uint32_t rows, const std::function<glm::dvec3(double, double)>& place) {
  MeshPart part;
  for (uint32_t y = 0; y <= rows; ++y) {
    for (uint32_t x = 0; x <= columns; ++x) {
      part.positions.emplace_back(place(static_cast<double>(x) / columns, static_cast<double>(y) / rows));
    }
  }
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t x = 0; x < columns; ++x) {
      const uint32_t a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      for (const uint32_t index : {a, c, b, b, c, d}) part.indices.push_back(index);
    }
  }
  return part;
}

inline Scene empty_scene() {
  Scene scene;
  scene.name = "hand-made";
  scene.materials.resize(1);
  return scene;
}

// Adds a mesh of one part and one object that places it; returns the object.
inline Object& add(Scene& scene, MeshPart part, const mat4& world_from_object = mat4(1.0f)) {
  Mesh mesh;
  mesh.parts.push_back(std::move(part));
  scene.meshes.push_back(std::move(mesh));
  Object object;
  object.mesh = static_cast<int>(scene.meshes.size()) - 1;
  object.world_from_object = world_from_object;
  scene.objects.push_back(object);
  return scene.objects.back();
}

inline Light sun(const vec3& direction, float angular_diameter = 0.0f) {
  Light light;
  light.direction = glm::normalize(direction);
  light.angular_diameter = angular_diameter;
  return light;
}

inline Light lamp(const vec3& position, float radius = 0.0f) {
  Light light;
  light.kind = LightKind::point;
  light.position = position;
  light.radius = radius;
  return light;
}

inline SurfacePoint floor_point(float x, float z, uint32_t pixel = 0) { return {vec3(x, 0, z), 0, vec3(0, 1, 0), pixel}; }

}  // namespace gnomon::test
