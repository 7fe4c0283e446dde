// The invariants of scene/scene.h, checked in one place for every loader and generator.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/scene.h"

namespace gnomon {
namespace {

template <class T>
bool finite(const T& value) {
  const float* numbers = glm::value_ptr(value);
  // NaN and infinity both make the difference with itself NaN; one sum keeps the loop free of branches.
  float sum = 0.0f;
  for (size_t i = 0; i < sizeof(T) / sizeof(float); ++i) sum += numbers[i] - numbers[i];
  return sum == 0.0f;
}

class Checker {
 public:
  explicit Checker(const Scene& scene) : scene_(scene), name_(scene.file_or_name()) {}

  void check() const {
    if (scene_.materials.empty()) fail("{}: materials: empty; at least one is needed", name_);
    for (size_t i = 0; i < scene_.textures.size(); ++i) check(scene_.textures[i], fmt::format("textures[{}]", i));
    for (size_t i = 0; i < scene_.materials.size(); ++i) check(scene_.materials[i], fmt::format("materials[{}]", i));
    for (size_t i = 0; i < scene_.meshes.size(); ++i) {
      const auto& parts = scene_.meshes[i].parts;
      for (size_t k = 0; k < parts.size(); ++k) check(parts[k], fmt::format("meshes[{}].parts[{}]", i, k));
    }
    for (size_t i = 0; i < scene_.objects.size(); ++i) check(scene_.objects[i], i);
    for (size_t i = 0; i < scene_.lights.size(); ++i) check(scene_.lights[i], fmt::format("lights[{}]", i));
    for (size_t i = 0; i < scene_.cameras.size(); ++i) check(scene_.cameras[i], fmt::format("cameras[{}]", i));
    for (size_t i = 0; i < scene_.camera_paths.size(); ++i) check(scene_.camera_paths[i], fmt::format("camera_paths[{}]", i));
    for (size_t i = 0; i < scene_.sun_paths.size(); ++i) check(scene_.sun_paths[i], fmt::format("sun_paths[{}]", i));
  }

 private:
  void require(bool condition, const std::string& place, const char* valid) const {
    if (!condition) fail("{}: {}: must be {}", name_, place, valid);
  }
  void require_index(int index, int lowest, size_t count, const std::string& place) const {
    if (index < lowest || index >= static_cast<int64_t>(count)) {
      fail("{}: {}: is {}; valid: {} to {}", name_, place, index, lowest, static_cast<int64_t>(count) - 1);
    }
  }
  template <class T>
  void require_finite(const std::vector<T>& values, const std::string& place) const {
    for (size_t i = 0; i < values.size(); ++i) {
      if (!finite(values[i])) fail("{}: {}[{}]: must be finite numbers", name_, place, i);
    }
  }
  // Of vectors whose first three components are a direction.
  template <class T>
  void require_unit(const std::vector<T>& values, const std::string& place) const {
    for (size_t i = 0; i < values.size(); ++i) {
      const vec3 v(values[i]);
      const float length = glm::dot(v, v);
      if (!(length > 0.98f && length < 1.02f))
        fail("{}: {}[{}]: must be a unit vector; its length is {}", name_, place, i, std::sqrt(length));
    }
  }

  void check(const Texture& texture, const std::string& place) const {
    const Image8& image = texture.image;
    require(image.width > 0 && image.height > 0, place + ".image", "at least 1 x 1 pixels");
    require(image.rgba.size() == static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 4, place + ".image",
            "width * height * 4 bytes");
  }

  void check(const Material& m, const std::string& place) const {
    require_index(m.base_colour_texture, k_no_texture, scene_.textures.size(), place + ".base_colour_texture");
    require_index(m.half_texture, k_no_texture, scene_.textures.size(), place + ".half_texture");
    require_index(m.normal_texture, k_no_texture, scene_.textures.size(), place + ".normal_texture");
    require(finite(m.base_colour) && finite(m.specular) && finite(m.emissive), place, "of finite colours");
    require(std::isfinite(m.normal_scale) && std::isfinite(m.alpha_cutoff), place, "of finite numbers");
    require(std::isfinite(m.shininess) && m.shininess >= 0.0f, place + ".shininess", "0 or more");
    for (const UvTransform* t : {&m.base_colour_uv, &m.normal_uv}) {
      require(finite(t->row_u) && finite(t->row_v), place, "of finite texture transforms");
    }
  }

  void check(const MeshPart& part, const std::string& place) const {
    const size_t count = part.positions.size();
    require(count <= 0xffffffffu, place + ".positions", "at most 2^32 - 1 vertices");
    for (const size_t size : {part.normals.size(), part.tangents.size(), part.uvs.size(), part.colours.size()}) {
      if (size != count) fail("{}: {}: a vertex array has {} entries where positions has {}", name_, place, size, count);
    }
    require(part.indices.size() % 3 == 0, place + ".indices", "three per triangle");
    for (size_t i = 0; i < part.indices.size(); ++i) {
      if (part.indices[i] >= count)
        fail("{}: {}.indices[{}]: is {}; there are {} vertices", name_, place, i, part.indices[i], count);
    }
    require_index(part.material, 0, scene_.materials.size(), place + ".material");
    require_finite(part.positions, place + ".positions");
    require_finite(part.uvs, place + ".uvs");
    require_finite(part.colours, place + ".colours");
    require_unit(part.normals, place + ".normals");
    require_unit(part.tangents, place + ".tangents");
    for (size_t i = 0; i < part.tangents.size(); ++i) {
      if (std::abs(part.tangents[i].w) != 1.0f) fail("{}: {}.tangents[{}].w: must be +1 or -1", name_, place, i);
    }
  }

  void check(const Object& object, size_t i) const {
    require_index(object.mesh, 0, scene_.meshes.size(), fmt::format("objects[{}].mesh", i));
    const mat4& m = object.world_from_object;
    const bool affine = m[0].w == 0.0f && m[1].w == 0.0f && m[2].w == 0.0f && m[3].w == 1.0f;
    if (!finite(m) || !affine) fail("{}: objects[{}].world_from_object: must be a finite affine matrix", name_, i);
  }

  void check(const Light& light, const std::string& place) const {
    require(finite(light.position), place + ".position", "finite");
    require(finite(light.direction) && std::abs(glm::length(light.direction) - 1.0f) < 1e-3f, place + ".direction",
            "a unit vector");
    require(finite(light.colour) && glm::all(glm::greaterThanEqual(light.colour, vec3(0.0f))), place + ".colour", "0 or more");
    const auto positive = [&](float value, const char* field) {
      require(std::isfinite(value) && value >= 0.0f, place + field, "a finite number, 0 or more");
    };
    positive(light.intensity, ".intensity");
    positive(light.angular_diameter, ".angular_diameter");
    positive(light.radius, ".radius");
    positive(light.range, ".range");
    positive(light.beam_radius, ".beam_radius");
    require(light.inner_cone >= 0.0f && light.inner_cone <= light.outer_cone, place + ".inner_cone", "0 to outer_cone");
    require(light.outer_cone <= 0.5f * k_pi + 1e-5f, place + ".outer_cone", "at most pi / 2");
  }

  void check(const Camera& camera, const std::string& place) const {
    require(finite(camera.world_from_view), place + ".world_from_view", "finite");
    require(camera.vertical_fov > 0.0f && camera.vertical_fov < k_pi, place + ".vertical_fov", "between 0 and pi");
    require(std::isfinite(camera.half_height) && camera.half_height > 0.0f, place + ".half_height", "above 0");
    require(camera.orthographic ? camera.near >= 0.0f : camera.near > 0.0f, place + ".near", "above 0");
    require(std::isfinite(camera.far) && camera.far > camera.near, place + ".far", "finite and beyond near");
  }

  void check(const CameraPath& path, const std::string& place) const {
    require(!path.keys.empty() && path.keys.front().time_s == 0.0, place + ".keys", "at least one, the first at 0 seconds");
    for (size_t i = 0; i < path.keys.size(); ++i) {
      require(finite(path.keys[i].eye) && finite(path.keys[i].target), place + ".keys", "finite");
      require(i == 0 || path.keys[i].time_s > path.keys[i - 1].time_s, place + ".keys", "in the order of their times");
    }
  }

  void check(const SunPath& path, const std::string& place) const {
    require(path.first_hour >= 0.0 && path.first_hour <= path.last_hour && path.last_hour <= 24.0, place,
            "within 0 to 24 hours");
    require(path.duration_s > 0.0, place + ".duration_s", "above 0");
    require(finite(path.colour) && std::isfinite(path.intensity), place, "of finite light");
  }

  const Scene& scene_;
  const std::string& name_;
};

}  // namespace

void check_scene(const Scene& scene) { Checker(scene).check(); }

}  // namespace gnomon
