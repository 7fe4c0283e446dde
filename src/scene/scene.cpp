// What can be said of a scene as a whole: bounds, counts, its content hash.
#include "scene/scene.h"

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
    values(m.specular, m.shininess, m.emissive);
    if (!m.casts || m.half_casts) values(m.casts, m.half_casts, m.half_texture);
    add(m.named_cast);
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
    values(object.mesh, object.world_from_object, object.casts);
    add(object.named_cast);
  }
  void add(const NamedCast& cast) {
    if (cast.rule >= 0) values(cast.rule, cast.on);
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

}  // namespace gnomon
