// The last step of every loader.
#include "scene/finish_part.h"

#include <cmath>

#include "base/interrupt.h"
#include "scene/mesh_tools.h"

namespace gnomon {
namespace {

// Unit length; vectors without a length get the normal of the faces around them.
void mend_normals(MeshPart& part) {
  std::vector<glm::dvec3> areas;
  for (size_t i = 0; i < part.normals.size(); ++i) {
    const glm::dvec3 normal(part.normals[i]);
    const double length = glm::length(normal);
    if (length > 1e-20 && std::isfinite(length)) {
      part.normals[i] = vec3(normal / length);
      continue;
    }
    if (areas.empty()) {
      areas.assign(part.positions.size(), glm::dvec3(0.0));
      for (size_t k = 0; k < part.indices.size(); k += 3) {
        const uint32_t* corner = &part.indices[k];
        const glm::dvec3 a(part.positions[corner[0]]), b(part.positions[corner[1]]), c(part.positions[corner[2]]);
        for (int j = 0; j < 3; ++j) areas[corner[j]] += glm::cross(b - a, c - a);
      }
    }
    const double area = glm::length(areas[i]);
    part.normals[i] = area > 0.0 ? vec3(areas[i] / area) : vec3(0, 1, 0);
  }
}

void mend_tangents(MeshPart& part) {
  for (size_t i = 0; i < part.tangents.size(); ++i) {
    const float handedness = part.tangents[i].w < 0.0f ? -1.0f : 1.0f;
    vec3 tangent(part.tangents[i]);
    const float length = glm::length(tangent);
    if (length > 1e-10f && std::isfinite(length)) {
      tangent /= length;
    } else {
      vec3 unused;
      orthonormal_basis(part.normals[i], tangent, unused);
    }
    part.tangents[i] = vec4(tangent, handedness);
  }
}

}  // namespace

void finish_part(MeshPart& part) {
  if (part.uvs.empty()) part.uvs.assign(part.positions.size(), vec2(0.0f));
  if (part.colours.empty()) part.colours.assign(part.positions.size(), vec4(1.0f));
  if (part.normals.empty()) {
    part.tangents.clear();
    make_normals(part, k_crease_angle);
  } else {
    mend_normals(part);
  }
  check_cancelled();
  if (part.tangents.empty()) {
    make_tangents(part);
  } else {
    mend_tangents(part);
  }
  check_cancelled();
  optimise(part);
}

}  // namespace gnomon
