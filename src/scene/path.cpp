// Splines for the viewer, a model of a day for the sun.
#include "scene/path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/hermite.h"

namespace gnomon {
namespace {

// A path that ends where it begins is a loop: it passes its seam as smoothly as any other key.
bool is_loop(std::span<const CameraKey> keys) {
  return keys.size() > 2 && keys.front().eye == keys.back().eye && keys.front().target == keys.back().target;
}

// Slope at key i of the parabola through it and its neighbours; at the ends of a path that is no loop, that of the chord.
vec3 tangent(std::span<const CameraKey> keys, size_t i, vec3 CameraKey::*member) {
  const auto slope = [&](size_t from, size_t to) {
    return (keys[to].*member - keys[from].*member) / static_cast<float>(keys[to].time_s - keys[from].time_s);
  };
  const size_t last = keys.size() - 1;
  if ((i == 0 || i == last) && !is_loop(keys)) return i == 0 ? slope(0, 1) : slope(last - 1, last);
  const size_t low = i == 0 ? last : i, high = i == last ? 0 : i;  // the same key, where a loop begins and ends
  const auto before = static_cast<float>(keys[low].time_s - keys[low - 1].time_s);
  const auto after = static_cast<float>(keys[high + 1].time_s - keys[high].time_s);
  return (slope(low - 1, low) * after + slope(high, high + 1) * before) / (before + after);
}

mat4 looking(const vec3& eye, const vec3& target) {
  const vec3 back = glm::normalize(eye - target);
  const vec3 up = std::abs(back.y) > 0.9999f ? vec3(0, 0, -1) : vec3(0, 1, 0);
  const vec3 right = glm::normalize(glm::cross(up, back));
  return mat4(vec4(right, 0), vec4(glm::cross(back, right), 0), vec4(back, 0), vec4(eye, 1));
}

constexpr double k_hour_angle = 2.0 * 3.14159265358979323846 / 24.0;  // radians an hour

// Toward the sun, with north at -Z, before the path's own turn: the standard hour-angle formulas.
glm::dvec3 to_sun_northward(const SunPath& path, double hour) {
  const double h = k_hour_angle * (hour - 12.0), sl = std::sin(path.latitude), cl = std::cos(path.latitude);
  const double sd = std::sin(path.declination), cd = std::cos(path.declination);
  const double east = -cd * std::sin(h), up = sl * sd + cl * cd * std::cos(h), north = cl * sd - sl * cd * std::cos(h);
  return {east, up, -north};
}

glm::dvec3 turned(const glm::dvec3& v, double angle) {  // about +Y
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

// Part of the light that the air lets through, by channel. Optical depths of a clear, slightly hazy sky at the zenith.
glm::dvec3 transmittance(double sine_elevation) {
  const double elevation = std::asin(std::clamp(sine_elevation, 0.0, 1.0)) * 180.0 / 3.14159265358979323846;
  const double air_mass = 1.0 / (sine_elevation + 0.50572 * std::pow(elevation + 6.07995, -1.6364));  // Kasten and Young 1989
  return glm::exp(-glm::dvec3(0.10, 0.16, 0.30) * std::max(air_mass, 1.0));
}

// Between two unit vectors, of which none is the other's opposite.
vec3 along_great_circle(const vec3& a, const vec3& b, float t) {
  // As a double: the angle between two keys of a slow sun is lost in a float's cosine.
  const glm::dvec3 from(a), to(b);
  const double angle = std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to)), part = static_cast<double>(t);
  const double sine = std::sin(angle);
  if (sine < 1e-9) return b;
  return vec3(glm::normalize((from * std::sin((1.0 - part) * angle) + to * std::sin(part * angle)) / sine));
}

double sine_elevation(const SunPath& path, double hour) { return std::clamp(to_sun_northward(path, hour).y, 0.0, 1.0); }

}  // namespace

double duration_s(const CameraPath& path) { return path.keys.empty() ? 0.0 : path.keys.back().time_s; }

CameraPose pose_at(const CameraPath& path, double time_s) {
  const std::span<const CameraKey> keys = path.keys;
  GNOMON_ASSERT(!keys.empty());
  if (keys.size() == 1 || time_s <= keys.front().time_s) return {keys.front().eye, keys.front().target};
  if (time_s >= keys.back().time_s) return {keys.back().eye, keys.back().target};
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), time_s, [](double t, const CameraKey& key) { return t < key.time_s; });
  const auto b = static_cast<size_t>(next - keys.begin()), a = b - 1;
  const double step = keys[b].time_s - keys[a].time_s;
  const auto t = static_cast<float>((time_s - keys[a].time_s) / step), step_s = static_cast<float>(step);
  const auto at = [&](vec3 CameraKey::*member) {
    return hermite(keys[a].*member, step_s * tangent(keys, a, member), keys[b].*member, step_s * tangent(keys, b, member), t);
  };
  return {at(&CameraKey::eye), at(&CameraKey::target)};
}

Camera camera_at(const CameraPath& path, double time_s, const Camera& like) {
  const CameraPose pose = pose_at(path, time_s);
  Camera camera = like;
  camera.name = path.name;
  if (glm::length(pose.eye - pose.target) > 0.0f) camera.world_from_view = looking(pose.eye, pose.target);
  return camera;
}

SunState sun_at(const SunPath& path, double hour) {
  hour = std::clamp(hour, path.first_hour, path.last_hour);
  const glm::dvec3 to_sun = turned(to_sun_northward(path, hour), path.turn);
  // Relative to the hour at which the path's own colour holds.
  const glm::dvec3 light = glm::dvec3(path.colour) * transmittance(sine_elevation(path, hour)) /
                           transmittance(sine_elevation(path, path.colour_hour));
  const double strongest = std::max({light.x, light.y, light.z, 1e-9});
  const double reference = std::max({path.colour.x, path.colour.y, path.colour.z, 1e-9f});
  return {glm::normalize(-vec3(to_sun)), vec3(light / strongest * reference),
          static_cast<float>(path.intensity * strongest / reference)};
}

NearestHour nearest_hour(const SunPath& path, const vec3& direction) {
  constexpr int k_steps = 240;
  NearestHour best = {path.first_hour, 4.0f};
  for (int i = 0; i <= k_steps; ++i) {
    const double hour = path.first_hour + (path.last_hour - path.first_hour) * i / k_steps;
    const glm::dvec3 a(sun_at(path, hour).direction), b(direction);
    const auto off = static_cast<float>(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    if (off < best.off) best = {hour, off};
  }
  return best;
}

double hour_at(const SunPath& path, double time_s) {
  return path.first_hour + (path.last_hour - path.first_hour) * std::clamp(time_s / path.duration_s, 0.0, 1.0);
}

SunState sun_at_time(const RecordedSun& path, double time_s) {
  GNOMON_ASSERT(!path.keys.empty());
  if (time_s <= path.keys.front().time_s) return path.keys.front().state;
  if (time_s >= path.keys.back().time_s) return path.keys.back().state;
  const auto b =
      std::upper_bound(path.keys.begin(), path.keys.end(), time_s, [](double t, const SunKey& key) { return t < key.time_s; });
  const auto a = b - 1;
  const auto t = static_cast<float>((time_s - a->time_s) / (b->time_s - a->time_s));
  return {along_great_circle(a->state.direction, b->state.direction, t), glm::mix(a->state.colour, b->state.colour, t),
          glm::mix(a->state.intensity, b->state.intensity, t)};
}

const std::string& name_of(const SunMotion& motion) {
  return std::visit([](const auto& path) -> const std::string& { return path.name; }, motion);
}

double duration_s(const SunMotion& motion) {
  if (const auto* day = std::get_if<SunPath>(&motion)) return day->duration_s;
  const auto& keys = std::get<RecordedSun>(motion).keys;
  return keys.empty() ? 0.0 : keys.back().time_s;
}

Light light_at(const SunMotion& motion, double time_s, Light sun) {
  const auto* day = std::get_if<SunPath>(&motion);
  const SunState state = day ? sun_at(*day, hour_at(*day, time_s)) : sun_at_time(std::get<RecordedSun>(motion), time_s);
  sun.direction = state.direction, sun.colour = state.colour, sun.intensity = state.intensity;
  return sun;
}

SunPath day_through(const std::string& name, const Light& sun) {
  SunPath path;
  path.name = name;
  path.colour = sun.colour, path.intensity = sun.intensity;
  const glm::dvec3 to_sun = -glm::normalize(glm::dvec3(sun.direction));
  const double elevation = std::asin(std::clamp(to_sun.y, -1.0, 1.0));
  // Nearer the equator where the sun of this latitude does not climb that high.
  const double highest = 0.5 * 3.14159265358979323846 - path.latitude + path.declination;
  if (elevation > highest) path.latitude -= elevation - highest;
  const double sl = std::sin(path.latitude), cl = std::cos(path.latitude), sd = std::sin(path.declination),
               cd = std::cos(path.declination);
  const auto hour_angle = [&](double sine) {
    return std::acos(std::clamp((sine - sl * sd) / (cl * cd), -1.0, 1.0)) / k_hour_angle;
  };
  path.colour_hour = 12.0 + hour_angle(to_sun.y);  // afternoon
  const double half_day = hour_angle(std::min(std::sin(3.0 * 3.14159265358979323846 / 180.0), to_sun.y));
  path.first_hour = 12.0 - half_day, path.last_hour = 12.0 + half_day;
  const glm::dvec3 here = to_sun_northward(path, path.colour_hour);
  path.turn = std::atan2(to_sun.x, to_sun.z) - std::atan2(here.x, here.z);
  return path;
}

CameraPath camera_path(const std::string& name, double duration_s, std::span<const CameraPose> poses) {
  GNOMON_ASSERT(poses.size() >= 2 && duration_s > 0.0);
  std::vector<double> way(poses.size(), 0.0);
  // Where the eye stands and only the target moves, time passes by the target's way.
  for (size_t i = 1; i < poses.size(); ++i) {
    const double moved = glm::length(poses[i].eye - poses[i - 1].eye),
                 turned_by = glm::length(poses[i].target - poses[i - 1].target);
    way[i] = way[i - 1] + std::max({moved, 0.1 * turned_by, 1e-6});
  }
  CameraPath path{name, {}};
  for (size_t i = 0; i < poses.size(); ++i)
    path.keys.push_back({duration_s * way[i] / way.back(), poses[i].eye, poses[i].target});
  return path;
}

CameraPath turn_path(const std::string& name, double duration_s, const Camera& camera, float distance_m) {
  constexpr int k_keys = 16;
  CameraPath path{name, {}};
  const vec3 eye(camera.world_from_view[3]), forward = -vec3(camera.world_from_view[2]);
  for (int i = 0; i <= k_keys; ++i) {
    const vec3 ahead(turned(glm::dvec3(forward), 2.0 * 3.14159265358979323846 * (i % k_keys) / k_keys));
    path.keys.push_back({duration_s * i / k_keys, eye, eye + distance_m * ahead});
  }
  return path;
}

CameraPath orbit_path(const std::string& name, double duration_s, const vec3& eye, const vec3& centre) {
  constexpr int k_keys = 16;
  CameraPath path{name, {}};
  for (int i = 0; i <= k_keys; ++i) {
    const glm::dvec3 arm = turned(glm::dvec3(eye - centre), 2.0 * 3.14159265358979323846 * (i % k_keys) / k_keys);
    path.keys.push_back({duration_s * i / k_keys, centre + vec3(arm), centre});
  }
  return path;
}

void add_paths(Scene& scene, std::span<const CameraPose> walk, std::span<const CameraPose> fly) {
  scene.camera_paths.push_back(camera_path("walk", 20.0, walk));
  scene.camera_paths.push_back(turn_path("turn", 20.0, scene.cameras.at(0), 10.0f));
  scene.camera_paths.push_back(camera_path("fly", 30.0, fly));
  add_default_paths(scene);  // the day
}

void add_default_paths(Scene& scene) {
  const Camera camera = scene.cameras.empty() ? framing_camera(scene, 1.5f) : scene.cameras.front();
  const Box box = scene.bounds();
  const vec3 centre = box.empty() ? vec3(0.0f) : box.centre(), eye(camera.world_from_view[3]),
             forward = -vec3(camera.world_from_view[2]);
  const float radius = box.empty() ? 1.0f : std::max(box.radius(), 1e-3f);
  // How far the camera looks: to the middle of the scene, as far as that lies ahead of it.
  const float ahead = std::clamp(glm::dot(centre - eye, forward), 0.2f * radius, 3.0f * radius);
  const vec3 target = eye + ahead * forward, side = vec3(camera.world_from_view[0]) * (0.15f * ahead);
  if (scene.camera_paths.empty()) {
    const std::array<CameraPose, 4> walk = {CameraPose{eye, target},
                                            CameraPose{eye + 0.2f * ahead * forward + 0.6f * side, target + 0.5f * side},
                                            CameraPose{eye + 0.4f * ahead * forward + side, target + side},
                                            CameraPose{eye + 0.6f * ahead * forward, target + 1.5f * side}};
    scene.camera_paths.push_back(camera_path("walk", 20.0, walk));
    scene.camera_paths.push_back(turn_path("turn", 20.0, camera, ahead));
    const vec3 from = framing_camera(scene, 1.5f).world_from_view[3];
    scene.camera_paths.push_back(orbit_path("fly", 30.0, centre + 0.8f * (from - centre), centre));
  }
  if (scene.sun_paths.empty()) {
    const auto sun =
        std::find_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.kind == LightKind::directional; });
    Light usual;
    usual.direction = glm::normalize(vec3(0.5f, -0.6f, -0.6f)), usual.intensity = 3.0f, usual.colour = vec3(1.0f, 0.95f, 0.88f);
    scene.sun_paths.push_back(day_through("day", sun != scene.lights.end() ? *sun : usual));
  }
}

}  // namespace gnomon
