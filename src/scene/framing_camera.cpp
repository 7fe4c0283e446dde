// The camera that shows a scene.
#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene.h"
#include "scene/subject.h"

namespace gnomon {
namespace {

// What the picture has to hold, relative to `origin`: the vertices inside the subject's box, or, where they are many, corners
// of boxes around objects.
std::vector<vec3> outline(const Scene& scene, const Subject& subject, const vec3& origin) {
  constexpr size_t k_many = 1 << 18;
  const bool many = 3 * scene.triangle_count() > k_many;
  std::vector<vec3> points;
  const Box& shown = subject.box;
  const auto inside = [&](const vec3& p) {
    return glm::all(glm::greaterThanEqual(p, shown.min)) && glm::all(glm::lessThanEqual(p, shown.max));
  };
  std::vector<Box> boxes;
  for (const Mesh& mesh : scene.meshes) boxes.push_back(many ? mesh.bounds() : Box());
  for (const Object& object : scene.objects) {
    const auto mesh = static_cast<size_t>(object.mesh);
    const mat4& world_from_object = object.world_from_object;
    if (many) {
      Box box = transformed(world_from_object, boxes[mesh]);
      box.min = glm::max(box.min, shown.min), box.max = glm::min(box.max, shown.max);
      const bool apart = glm::any(glm::greaterThan(box.min, box.max));
      for (int k = 0; k < 8 && !apart; ++k) points.push_back(box.corner(k) - origin);
      continue;
    }
    for (const MeshPart& part : scene.meshes[mesh].parts) {
      for (const vec3& position : part.positions) {
        const vec3 p(world_from_object * vec4(position, 1.0f));
        if (!subject.cropped || inside(p)) points.push_back(p - origin);
      }
    }
  }
  // The ground around it has no vertices there.
  for (int k = 0; k < 8 && subject.cropped; ++k) {
    if ((k & 2) == 0) points.push_back(shown.corner(k) - origin);
  }
  return points;
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
  const Subject subject = find_subject(scene);
  Box all = scene.bounds(), box = subject.cropped ? subject.box : all;
  if (box.empty()) box.add(vec3(0.0f));
  const vec3 origin = box.centre();
  // A scene of one point has no size; any view of it will do.
  float radius = std::max(box.radius(), 1e-3f * glm::length(box.centre()));
  if (radius == 0.0f) radius = 1.0f;

  const float tan_y = std::tan(0.5f * camera.vertical_fov) / k_margin;
  const vec2 tangents(tan_y * std::max(aspect, 1e-3f), tan_y);
  const std::vector<vec3> points = outline(scene, subject, origin);
  Fit fit(points, k_azimuth, k_elevation, tangents);
  for (const float azimuth : k_across) {
    const Fit other(points, azimuth, k_elevation, tangents);
    if (other.distance * k_larger < fit.distance) fit = other;
  }
  // A sheet seen edge-on still needs room between it and the eye.
  const float distance = std::max({fit.distance, fit.nearest + 0.02f * radius, 1e-3f * radius});
  const vec3 position = origin + fit.centre.x * fit.right + fit.centre.y * fit.up + distance * fit.back;
  camera.world_from_view = mat4(vec4(fit.right, 0), vec4(fit.up, 0), vec4(fit.back, 0), vec4(position, 1));
  camera.near = std::max(0.5f * (distance - fit.nearest), 1e-3f * distance);
  if (all.empty()) all = box;
  float farthest = 0.0f;  // also of ground that the picture need not hold
  for (int k = 0; k < 8; ++k) farthest = std::max(farthest, -glm::dot(all.corner(k) - origin, fit.back));
  camera.far = 1.5f * (distance + farthest);
  return camera;
}

}  // namespace gnomon
