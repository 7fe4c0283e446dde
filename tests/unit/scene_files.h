// Files and measures that the tests of the scene loaders share.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

#include "base/image.h"
#include "base/temporary_folder.h"
#include "scene/scene.h"

namespace gnomon::test_files {

class Folder : public TemporaryFolder {
 public:
  void picture(const std::string& name, int width, int height,
               const std::function<std::array<uint8_t, 4>(int, int)>& colour) const {
    Image8 image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) std::ranges::copy(colour(x, y), image.at(x, y));
    }
    write_png(path() / name, image);
  }
};

inline double area(const MeshPart& part) {
  double sum = 0.0;
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    const glm::dvec3 a(part.positions[part.indices[i]]), b(part.positions[part.indices[i + 1]]),
        c(part.positions[part.indices[i + 2]]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

// World space, instances counted.
inline double area(const Scene& scene) {
  double sum = 0.0;
  for (const Object& object : scene.objects) {
    for (MeshPart part : scene.meshes[static_cast<size_t>(object.mesh)].parts) {
      for (vec3& p : part.positions) p = vec3(object.world_from_object * vec4(p, 1.0f));
      sum += area(part);
    }
  }
  return sum;
}

}  // namespace gnomon::test_files
