// Sizes, areas, strays.
#include "scene/drawable.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "scene/casting.h"
#include "scene/subject.h"

namespace gnomon {
namespace {

// A face's normal has the square of its size as its length, and its length is a square again: the fourth power has to fit.
constexpr float k_largest_m = 4e9f;
// The square of a face's normal has to fit as well: of a triangle of a thousandth of the scene.
constexpr float k_smallest_m = 1e-6f;

const Mesh& mesh_of(const Scene& scene, const Object& object) { return scene.meshes[static_cast<size_t>(object.mesh)]; }

std::string text(const vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

class Drawable {
 public:
  explicit Drawable(const Scene& scene) : scene_(scene), name_(scene.file_or_name()) {}

  void check() const {
    if (scene_.triangle_count() == 0) {
      const bool has_faces =
          std::any_of(scene_.meshes.begin(), scene_.meshes.end(), [](const Mesh& mesh) { return !mesh.parts.empty(); });
      fail("{}: nothing to draw: the scene has no triangles{}", name_,
           has_faces ? ": none of its faces has an area, their corners lie on lines or at one point" : "");
    }
    check_largest();
    const vec3 extent = scene_.bounds().extent();
    const float size = std::max({extent.x, extent.y, extent.z});
    if (size > 0.0f && size < k_smallest_m) {
      fail(
          "{}: nothing to draw: the scene is {:.3g} m across; valid: at least {:.0g} m, since areas of less do not fit 32-bit "
          "floats",
          name_, size, k_smallest_m);
    }
    if (!has_area()) {
      fail("{}: nothing to draw: no triangle has an area; {}", name_,
           size > 0.0f ? "their corners lie on lines" : "all vertices lie at one point, as of a node that is scaled by 0");
    }
  }

 private:
  // Calls action(object, position in its own space, position in the world) for every step-th vertex.
  template <class Action>
  void each_vertex(size_t step, const Action& action) const {
    size_t next = 0;
    for (const Object& object : scene_.objects) {
      for (const MeshPart& part : mesh_of(scene_, object).parts) {
        for (; next < part.positions.size(); next += step) {
          const vec3& p = part.positions[next];
          action(object, p, vec3(object.world_from_object * vec4(p, 1.0f)));
        }
        next -= part.positions.size();
      }
    }
  }

  static float largest(const vec3& p) {
    const vec3 size = glm::abs(p);
    const float result = std::max({size.x, size.y, size.z});
    return std::isfinite(size.x + size.y + size.z) ? result : std::numeric_limits<float>::infinity();
  }

  // Rays are traced in an object's own space, too.
  void check_largest() const {
    each_vertex(1, [&](const Object& object, const vec3& own, const vec3& world) {
      if (largest(own) <= k_largest_m && largest(world) <= k_largest_m) return;
      fail(
          "{}: object '{}' has a vertex at {}{}; valid: coordinates up to {:.0g} m, since areas of more do not fit 32-bit "
          "floats",
          name_, object.name, text(own), world == own ? "" : ", which is placed at " + text(world), k_largest_m);
    });
  }

  bool has_area() const {
    for (const Object& object : scene_.objects) {
      for (const MeshPart& part : mesh_of(scene_, object).parts) {
        for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
          glm::dvec3 corner[3];
          for (size_t k = 0; k < 3; ++k) {
            const vec4 p(part.positions[part.indices[i + k]], 1.0f);
            corner[k] = glm::dvec3(vec3(object.world_from_object * p));
          }
          if (glm::cross(corner[1] - corner[0], corner[2] - corner[0]) != glm::dvec3(0.0)) return true;
        }
      }
    }
    return false;
  }

  const Scene& scene_;
  const std::string& name_;
};

}  // namespace

void check_drawable(const Scene& scene) { Drawable(scene).check(); }

void warn_of_strays(const Scene& scene) {
  const Subject subject = find_subject(scene);
  const Object* first = nullptr;
  vec3 position(0.0f);
  float farthest = 0.0f;
  size_t count = 0;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!subject.stray[i] || !object_casts(scene, object)) continue;
    ++count;
    for (const MeshPart& part : mesh_of(scene, object).parts) {
      for (const vec3& own : part.positions) {
        const vec3 p(object.world_from_object * vec4(own, 1.0f));
        if (const float distance = glm::distance(p, subject.middle); distance > farthest)
          first = &object, position = p, farthest = distance;
      }
    }
  }
  if (!first) return;
  log_warning(
      "{}: object '{}' reaches to {}, {:.2g} times as far out as the rest of the scene{}: the camera that frames the scene "
      "leaves that out, but shadow maps span it and are coarse for the rest; remove it, or leave it out of the maps with "
      "--cast '{}=off'",
      scene.file_or_name(), first->name, text(position), farthest / subject.usual_m,
      count > 1 ? fmt::format(" ({} such objects)", count) : "", first->name);
}

}  // namespace gnomon
