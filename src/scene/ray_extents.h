// What decides how far off its surface a ray must start: the extents of ray_origin() (base/glsl/sampling.glsl).
#pragma once

#include <algorithm>

#include "scene/scene.h"

namespace gnomon {

// A tracer computes dot(n, vertex - origin) in object space; each product rounds relative to |n_i| times the triangle's extent
// along axis i. Largest sum of those over a part's triangles, in object units: zero for axis-aligned ground, however large.
inline float plane_extent(const MeshPart& part) {
  float largest = 0.0f;
  for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const vec3 a = part.positions[part.indices[i]], b = part.positions[part.indices[i + 1]],
               c = part.positions[part.indices[i + 2]];
    const vec3 normal = glm::cross(b - a, c - a);
    const float length = glm::length(normal);
    if (!(length > 0.0f)) continue;
    const vec3 extent = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
    largest = std::max(largest, glm::dot(glm::abs(normal), extent) / length);
  }
  return largest;
}

// Of all casters, in metres.
inline float plane_extent(const Scene& scene) {
  std::vector<std::vector<float>> of_part(scene.meshes.size());
  for (size_t i = 0; i < scene.meshes.size(); ++i) {
    for (const MeshPart& part : scene.meshes[i].parts) of_part[i].push_back(plane_extent(part));
  }
  float largest = 0.0f;
  for (const Object& object : scene.objects) {
    const mat3 m(object.world_from_object);
    const float scale = std::max(glm::length(m[0]), std::max(glm::length(m[1]), glm::length(m[2])));
    const auto mesh = static_cast<size_t>(object.mesh);
    for (size_t i = 0; i < of_part[mesh].size(); ++i) {
      const auto material = static_cast<size_t>(scene.meshes[mesh].parts[i].material);
      if (part_casts(object, scene.materials[material])) largest = std::max(largest, scale * of_part[mesh][i]);
    }
  }
  return largest;
}

// {plane_extent, the least coordinate that counts}: a metre, or the largest coordinate of a scene that is smaller. In metres.
inline vec2 ray_extents(const Scene& scene) {
  const Box box = scene.bounds();
  const vec3 largest = glm::max(glm::abs(box.min), glm::abs(box.max));
  return {plane_extent(scene), std::min(std::max(largest.x, std::max(largest.y, largest.z)), 1.0f)};
}

}  // namespace gnomon
