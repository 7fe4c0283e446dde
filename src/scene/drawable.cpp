// Sizes, areas, strays.
#include "scene/drawable.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/log.h"

namespace gnomon {
namespace {

// A face's normal has the square of its size as its length, and its length is a square again: the fourth power has to fit.
constexpr float k_largest_m = 4e9f;
// Rays start at least 1.9e-6 m off their surface (base/glsl/sampling.glsl), beyond all that is smaller.
constexpr float k_smallest_m = 1e-5f;
// Beyond this many times the distance of most vertices from their middle, a map of 4096 texels has none left for them.
constexpr float k_stray = 1e4f;

const Mesh& mesh_of(const Scene& scene, const Object& object) { return scene.meshes[static_cast<size_t>(object.mesh)]; }

std::string text(const vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

class Drawable {
 public:
  explicit Drawable(const Scene& scene) : scene_(scene), name_(scene.source.empty() ? scene.name : scene.source) {}

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
    warn_of_strays();
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

  void warn_of_strays() const {
    constexpr size_t k_samples = 1 << 14;
    size_t vertices = 0;
    for (const Object& object : scene_.objects) {
      for (const MeshPart& part : mesh_of(scene_, object).parts) vertices += part.positions.size();
    }
    std::vector<vec3> sample;
    each_vertex(vertices / k_samples + 1, [&](const Object&, const vec3&, const vec3& world) { sample.push_back(world); });
    const auto middle_of = [&](const auto& less) {
      const auto middle = sample.begin() + static_cast<ptrdiff_t>(sample.size() / 2);
      std::nth_element(sample.begin(), middle, sample.end(), less);
      return *middle;
    };
    vec3 centre;
    for (int axis = 0; axis < 3; ++axis)
      centre[axis] = middle_of([axis](const vec3& a, const vec3& b) { return a[axis] < b[axis]; })[axis];
    const float usual = glm::distance(
        centre, middle_of([&](const vec3& a, const vec3& b) { return glm::distance(a, centre) < glm::distance(b, centre); }));
    const Box box = scene_.bounds();
    if (!(usual > 0.0f) || largest(glm::max(box.max - centre, centre - box.min)) < k_stray * usual) return;

    size_t count = 0;
    const Object* first = nullptr;
    vec3 position(0.0f);
    each_vertex(1, [&](const Object& object, const vec3&, const vec3& world) {
      if (glm::distance(world, centre) < k_stray * usual) return;
      if (count++ == 0) first = &object, position = world;
    });
    if (!first) return;
    log_warning(
        "{}: object '{}' has a vertex at {}, {:.2g} times as far out as most of the scene{}: a shadow map that spans it has no "
        "texel left for the rest; remove it, or leave it out with --cast",
        name_, first->name, text(position), glm::distance(position, centre) / usual,
        count > 1 ? fmt::format(" ({} such vertices)", count) : "");
  }

  const Scene& scene_;
  const std::string& name_;
};

}  // namespace

void check_drawable(const Scene& scene) { Drawable(scene).check(); }

}  // namespace gnomon
