// Floor and sun of the charts.
#include "scene/builtin/parts/chart.h"

#include <cmath>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/shapes.h"

namespace gnomon {
namespace {

// elevation above the horizon; azimuth 0 lets the light travel along +X, 90 along +Z.
Light sun_of(const BuiltinOptions& options) {
  const glm::dvec2 around = unit_circle(radians_of(options.at("azimuth"))),
                   up = unit_circle(radians_of(options.at("elevation")));
  Light sun;
  sun.name = "sun";
  sun.direction = vec3(glm::dvec3(around.x * up.x, -up.y, around.y * up.x));
  sun.intensity = 3.0f;
  sun.angular_diameter = static_cast<float>(radians_of(options.at("sun_deg")));
  return sun;
}

}  // namespace

std::vector<BuiltinOption> with_sun(double elevation, double azimuth, std::vector<BuiltinOption> options) {
  options.push_back({"elevation", elevation, 5.0, 90.0, "Height of the sun above the horizon [degrees]"});
  options.push_back({"azimuth", azimuth, -180.0, 180.0, "Where the light travels: 0 along +X, 90 along +Z [degrees]"});
  options.push_back({"sun_deg", 0.0, 0.0, 5.0, "Angular diameter of the sun's disc; 0 is a hard light [degrees]"});
  return options;
}

Scene chart_with_floor(const std::string& name, float half_side_m, const BuiltinOptions& options) {
  Scene scene;
  scene.name = name;
  Material floor;
  floor.name = "floor", floor.base_colour = vec4(0.6f, 0.6f, 0.6f, 1.0f);
  const int floor_material = add_material(scene, floor);
  Material caster;
  caster.name = "caster", caster.base_colour = vec4(0.55f, 0.22f, 0.10f, 1.0f);
  add_material(scene, caster);
  MeshPart part = part_of(floor_material);
  const float s = half_side_m;
  add_quad(part, {-s, 0, s}, {s, 0, s}, {s, 0, -s}, {-s, 0, -s}, {0, 0}, {2 * s, 2 * s});
  add_object(scene, "floor", add_mesh(scene, "floor", {part}));
  scene.lights.push_back(sun_of(options));
  return scene;
}

vec3 shadow_on_floor(const Scene& scene, const vec3& point) {
  const vec3 direction = scene.lights.front().direction;
  const vec2 away = vec2(direction.x, direction.z) * (point.y / -direction.y);
  const float distance = glm::length(away), reach = 10.0f;
  const vec2 kept = distance > reach ? away * (reach / distance) : away;
  return {point.x + kept.x, 0.0f, point.z + kept.y};
}

bool is_floor_point(const glm::dvec3& point) { return std::abs(point.y) <= 1e-4; }

}  // namespace gnomon
