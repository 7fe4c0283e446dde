// What can be said of a scene as a whole: bounds, counts, its content hash, a camera that shows it.
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"

namespace gnomon {

UvTransform UvTransform::from(vec2 offset, float rotation, vec2 scale) {
  // Counter-clockwise as seen with v downward. The matrix printed in KHR_texture_transform turns the other way; its own
  // example ("lower left quadrant"), three.js and Babylon.js agree on this one.
  const float c = std::cos(rotation), s = std::sin(rotation);
  UvTransform result;
  result.row_u = vec3(c * scale.x, s * scale.y, offset.x);
  result.row_v = vec3(-s * scale.x, c * scale.y, offset.y);
  return result;
}

Box Mesh::bounds() const {
  Box box;
  for (const MeshPart& part : parts) {
    for (const vec3& position : part.positions) box.add(position);
  }
  return box;
}

Box Scene::bounds() const {
  std::vector<Box> mesh_bounds;
  mesh_bounds.reserve(meshes.size());
  for (const Mesh& mesh : meshes) mesh_bounds.push_back(mesh.bounds());
  Box box;
  for (const Object& object : objects) {
    const Box placed = transformed(object.world_from_object, mesh_bounds.at(static_cast<size_t>(object.mesh)));
    if (!placed.empty()) box.add(placed);
  }
  return box;
}

size_t Scene::triangle_count() const {
  std::vector<size_t> of_mesh;
  of_mesh.reserve(meshes.size());
  for (const Mesh& mesh : meshes) {
    size_t count = 0;
    for (const MeshPart& part : mesh.parts) count += part.triangle_count();
    of_mesh.push_back(count);
  }
  size_t count = 0;
  for (const Object& object : objects) count += of_mesh.at(static_cast<size_t>(object.mesh));
  return count;
}

namespace {

// Adds fields one by one: the padding inside a struct is not content. Sizes keep neighbouring arrays apart.
class SceneHash {
 public:
  template <class... Values>
  void values(const Values&... values) {
    (hash_.add_value(values), ...);
  }
  template <class T>
  void array(const std::vector<T>& items) {
    hash_.add_value(static_cast<uint64_t>(items.size()));
    hash_.add_values(items);
  }
  void add(const Texture& texture) {
    values(texture.image.width, texture.image.height, texture.srgb, texture.wrap_u, texture.wrap_v);
    array(texture.image.rgba);
  }
  void add(const UvTransform& transform) { values(transform.row_u, transform.row_v); }
  void add(const Material& m) {
    values(m.base_colour, m.base_colour_texture, m.normal_texture, m.normal_scale, m.masked, m.alpha_cutoff, m.double_sided);
    values(m.specular, m.shininess, m.emissive, m.casts, m.half_casts, m.named_cast.rule, m.named_cast.on);
    add(m.base_colour_uv);
    add(m.normal_uv);
  }
  void add(const MeshPart& part) {
    array(part.positions);
    array(part.normals);
    array(part.tangents);
    array(part.uvs);
    array(part.colours);
    array(part.indices);
    values(part.material);
  }
  void add(const Mesh& mesh) { all(mesh.parts); }
  void add(const Object& object) {
    values(object.mesh, object.world_from_object, object.casts, object.named_cast.rule, object.named_cast.on);
  }
  void add(const Light& light) {
    values(light.kind, light.position, light.direction, light.colour, light.intensity, light.angular_diameter);
    values(light.radius, light.range, light.inner_cone, light.outer_cone, light.beam_radius);
  }
  void add(const Camera& camera) {
    values(camera.world_from_view, camera.orthographic, camera.vertical_fov, camera.half_height, camera.near, camera.far);
  }
  template <class T>
  void all(const std::vector<T>& items) {
    hash_.add_value(static_cast<uint64_t>(items.size()));
    for (const T& item : items) add(item);
  }
  std::string hex() const { return hash_.hex(); }

 private:
  ContentHash hash_;
};

}  // namespace

std::string Scene::content_hash() const {
  SceneHash hash;
  hash.all(textures);
  hash.all(materials);
  hash.all(meshes);
  hash.all(objects);
  hash.all(lights);
  hash.all(cameras);
  return hash.hex();
}

Camera framing_camera(const Scene& scene, float aspect) {
  // The sun of a scene without lights (lab/view/light.params) stands at its left: shadows are in sight.
  constexpr float k_elevation = k_pi / 6.0f, k_azimuth = k_pi / 5.0f, k_margin = 1.05f;
  Camera camera;
  camera.name = "framing";
  camera.vertical_fov = k_pi / 4.0f;
  Box box = scene.bounds();
  if (box.empty()) box.add(vec3(0.0f));
  // A scene of one point has no size; any view of it will do.
  const float radius = std::max({box.radius(), 1e-3f * glm::length(box.centre()), 1e-3f});

  // Towards the viewer: from above, front and right.
  const vec3 back(std::cos(k_elevation) * std::sin(k_azimuth), std::sin(k_elevation),
                  std::cos(k_elevation) * std::cos(k_azimuth));
  const vec3 right = glm::normalize(glm::cross(vec3(0, 1, 0), back));
  const vec3 up = glm::cross(back, right);
  const float tan_y = std::tan(0.5f * camera.vertical_fov), tan_x = tan_y * std::max(aspect, 1e-3f);

  // The smallest distance at which all corners are inside the four side planes.
  float distance = 0.0f, nearest = -radius, farthest = radius;
  for (int i = 0; i < 8; ++i) {
    const vec3 corner = box.corner(i) - box.centre();
    const float x = std::abs(glm::dot(corner, right)), y = std::abs(glm::dot(corner, up)), z = glm::dot(corner, back);
    distance = std::max({distance, z + x / tan_x, z + y / tan_y});
    nearest = std::max(nearest, z), farthest = std::max(farthest, -z);
  }
  distance = std::max(distance * k_margin, radius);
  const vec3 position = box.centre() + distance * back;
  camera.world_from_view = mat4(vec4(right, 0), vec4(up, 0), vec4(back, 0), vec4(position, 1));
  camera.near = std::max(0.5f * (distance - nearest), 1e-3f * distance);
  camera.far = 1.5f * (distance + farthest);
  return camera;
}

}  // namespace gnomon
