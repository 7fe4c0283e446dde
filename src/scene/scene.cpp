// What can be said of a scene as a whole: bounds, counts, its content hash, a camera that shows it.
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

namespace {

// A place that the picture may have to hold. The weights of an object add up to the square root of its vertices: one statue of
// a million in a hall is not all that there is to see.
struct Place {
  vec3 position;
  double weight;
};

// All vertices, or, where they are many, the corners of boxes around meshes; relative to `origin`.
std::vector<Place> places_of(const Scene& scene, const vec3& origin) {
  constexpr size_t k_many = 1 << 18;
  std::vector<std::vector<Place>> of_mesh(scene.meshes.size());
  const bool many = 3 * scene.triangle_count() > k_many;
  for (size_t i = 0; i < scene.meshes.size(); ++i) {
    size_t vertices = 0;
    for (const MeshPart& part : scene.meshes[i].parts) {
      vertices += part.positions.size();
      for (size_t v = 0; v < part.positions.size() && !many; ++v) of_mesh[i].push_back({part.positions[v], 1.0});
    }
    const Box box = scene.meshes[i].bounds();
    for (int k = 0; k < 8 && many && !box.empty(); ++k)
      of_mesh[i].push_back({box.corner(k), static_cast<double>(vertices) / 8.0});
  }
  std::vector<Place> places;
  for (const Object& object : scene.objects) {
    for (const Place& place : of_mesh.at(static_cast<size_t>(object.mesh)))
      places.push_back({vec3(object.world_from_object * vec4(place.position, 1.0f)) - origin, place.weight});
  }
  return places;
}

// Where along an axis all but a hundredth of the weight lies at either end.
std::pair<float, float> crowd_along(std::vector<Place> places, int axis) {
  constexpr double k_few = 0.01;
  std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) { return a.position[axis] < b.position[axis]; });
  double all = 0.0, passed = 0.0;
  for (const Place& place : places) all += place.weight;
  std::pair<float, float> crowd = {places.front().position[axis], places.back().position[axis]};
  for (const Place& place : places) {
    if (passed <= k_few * all) crowd.first = place.position[axis];
    if (passed <= (1.0 - k_few) * all) crowd.second = place.position[axis];
    passed += place.weight;
  }
  return crowd;
}

// What the picture has to hold. Ground that goes on far beyond all that stands on it, to a horizon, would leave a town some
// twenty pixels: where the scene is k_wider times as wide as the part that holds nearly all of its vertices, that part is
// shown.
std::vector<vec3> outline(const Scene& scene, const vec3& origin) {
  constexpr float k_wider = 2.5f;
  const std::vector<Place> places = places_of(scene, origin);
  std::vector<vec3> points, crowded;
  if (places.empty()) return points;
  const auto [x0, x1] = crowd_along(places, 0);
  const auto [z0, z1] = crowd_along(places, 2);
  Box all, crowd;
  for (const Place& place : places) {
    const vec3& p = place.position;
    points.push_back(p);
    all.add(p);
    if (p.x < x0 || p.x > x1 || p.z < z0 || p.z > z1) continue;
    crowded.push_back(p);
    crowd.add(p);
  }
  const auto width = [](const Box& box) { return std::max(box.max.x - box.min.x, box.max.z - box.min.z); };
  return crowded.empty() || width(all) < k_wider * width(crowd) ? points : crowded;
}

// A camera that looks along -back, and as near as it may be for all points to be in the picture.
struct Fit {
  vec3 right, up, back;
  vec2 centre = vec2(0.0f);  // of the picture, along right and up
  float distance = 0.0f, nearest = 0.0f;

  Fit(const std::vector<vec3>& points, float azimuth, float elevation, const vec2& tangents)
      : back(std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)) {
    right = glm::normalize(glm::cross(vec3(0, 1, 0), back));
    up = glm::cross(back, right);
    // Where the planes of the picture's edges touch, as they cross the plane through the origin.
    constexpr float k_none = std::numeric_limits<float>::lowest();
    vec2 low(k_none), high(k_none);
    for (const vec3& point : points) {
      const vec2 place(glm::dot(point, right), glm::dot(point, up));
      const float z = glm::dot(point, back);
      high = glm::max(high, place + z * tangents), low = glm::max(low, z * tangents - place);
      nearest = std::max(nearest, z);
    }
    if (points.empty()) return;
    centre = 0.5f * (high - low);
    const vec2 distances = 0.5f * (high + low) / tangents;
    distance = std::max(distances.x, distances.y);
  }
};

}  // namespace

Camera framing_camera(const Scene& scene, float aspect) {
  // The sun of a scene without lights (lab/view/light.params) stands at its left: shadows are in sight.
  constexpr float k_elevation = k_pi / 6.0f, k_azimuth = k_pi / 5.0f, k_margin = 1.05f;
  // What is long lies across the picture where that shows it much larger.
  constexpr float k_across[] = {k_pi / 18.0f, 8.0f * k_pi / 18.0f}, k_larger = 1.5f;
  Camera camera;
  camera.name = "framing";
  camera.vertical_fov = k_pi / 4.0f;
  Box box = scene.bounds();
  if (box.empty()) box.add(vec3(0.0f));
  // A scene of one point has no size; any view of it will do.
  float radius = std::max(box.radius(), 1e-3f * glm::length(box.centre()));
  if (radius == 0.0f) radius = 1.0f;

  const float tan_y = std::tan(0.5f * camera.vertical_fov) / k_margin;
  const vec2 tangents(tan_y * std::max(aspect, 1e-3f), tan_y);
  const std::vector<vec3> points = outline(scene, box.centre());
  Fit fit(points, k_azimuth, k_elevation, tangents);
  for (const float azimuth : k_across) {
    const Fit other(points, azimuth, k_elevation, tangents);
    if (other.distance * k_larger < fit.distance) fit = other;
  }
  // A sheet seen edge-on still needs room between it and the eye.
  const float distance = std::max({fit.distance, fit.nearest + 0.02f * radius, 1e-3f * radius});
  const vec3 position = box.centre() + fit.centre.x * fit.right + fit.centre.y * fit.up + distance * fit.back;
  camera.world_from_view = mat4(vec4(fit.right, 0), vec4(fit.up, 0), vec4(fit.back, 0), vec4(position, 1));
  camera.near = std::max(0.5f * (distance - fit.nearest), 1e-3f * distance);
  float farthest = 0.0f;  // also of ground that the picture need not hold
  for (int k = 0; k < 8; ++k) farthest = std::max(farthest, -glm::dot(box.corner(k) - box.centre(), fit.back));
  camera.far = 1.5f * (distance + farthest);
  return camera;
}

}  // namespace gnomon
