// Which camera and which lights a picture has.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "base/error.h"
#include "lab/view/lab_params.h"
#include "lab/view/light_text.h"
#include "lab/view/path_file.h"
#include "lab/view/session.h"

namespace gnomon {
namespace {

// The index that `text` names in a list of things with a name, or nullopt.
template <class T>
std::optional<size_t> find_named(const std::vector<T>& list, const std::string& text) {
  for (size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == text) return i;
  }
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number < list.size()) return number;
  return std::nullopt;
}

template <class T>
std::string names_of(const std::vector<T>& list) {
  std::vector<std::string> names;
  for (size_t i = 0; i < list.size(); ++i) names.push_back(fmt::format("{} ('{}')", i, list[i].name));
  return names.empty() ? "none in this scene" : fmt::format("{}", fmt::join(names, ", "));
}

// "eye:target" in metres.
std::optional<Camera> parse_camera(const std::string& text, const Scene& scene) {
  const size_t colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  const auto eye = parse_vec3(std::string_view(text).substr(0, colon)),
             target = parse_vec3(std::string_view(text).substr(colon + 1));
  if (!eye || !target || *eye == *target) return std::nullopt;
  Camera camera;
  camera.name = text;
  const vec3 forward = glm::normalize(*target - *eye);
  const vec3 up = std::abs(forward.y) > 0.999f ? vec3(0, 0, -1) : vec3(0, 1, 0);
  camera.world_from_view = glm::inverse(glm::lookAt(*eye, *target, up));
  camera.far = std::max(2.0f * scene.bounds().radius() + glm::length(*eye - scene.bounds().centre()), 1.0f);
  return camera;
}

float degrees(float radians) { return radians * 180.0f / k_pi; }
float radians(double degree) { return static_cast<float>(degree) * k_pi / 180.0f; }

// The settings that the user gave override the scene's light.
void override_light(Light& light, const Settings& settings) {
  const auto params = settings.block("light").as<light_params::Params>();
  if (light.kind == LightKind::directional) {
    if (settings.was_set("light.azimuth") || settings.was_set("light.elevation")) {
      light_params::Params merged = params;
      const vec3 to_sun = -light.direction;
      if (!settings.was_set("light.azimuth")) merged.azimuth = degrees(std::atan2(to_sun.x, -to_sun.z));
      if (!settings.was_set("light.elevation")) merged.elevation = degrees(std::asin(glm::clamp(to_sun.y, -1.0f, 1.0f)));
      light.direction = sun_direction(merged.azimuth, merged.elevation);
    }
    if (settings.was_set("light.angular_diameter")) light.angular_diameter = radians(params.angular_diameter);
  }
  if (settings.was_set("light.intensity")) light.intensity = params.intensity;
}

Light default_sun(const Settings& settings) {
  const auto params = settings.block("light").as<light_params::Params>();
  Light sun;
  sun.name = "sun";
  sun.direction = sun_direction(params.azimuth, params.elevation);
  sun.angular_diameter = radians(params.angular_diameter);
  sun.intensity = params.intensity;
  return sun;
}

// Lights of one name become "point", "point 2", ...: every table and every message names them.
void name_apart(std::vector<Light>& lights) {
  std::map<std::string, int> seen;
  for (Light& light : lights) {
    if (const int count = ++seen[light.name]; count > 1) light.name += fmt::format(" {}", count);
  }
}

}  // namespace

void record_light(const Light& light, Settings& settings) {
  if (light.kind == LightKind::directional) {
    const vec3 to_sun = -light.direction;
    settings.set_effective("light", "azimuth", degrees(std::atan2(to_sun.x, -to_sun.z)));
    settings.set_effective("light", "elevation", degrees(std::asin(glm::clamp(to_sun.y, -1.0f, 1.0f))));
    settings.set_effective("light", "angular_diameter", degrees(light.angular_diameter));
  }
  settings.set_effective("light", "intensity", light.intensity);
}

Camera choose_camera(const Scene& scene, const ViewOptions& options, Settings& settings) {
  const float aspect = static_cast<float>(options.size.x) / static_cast<float>(options.size.y);
  Camera camera;
  if (options.camera.empty()) {
    camera = scene.cameras.empty() ? framing_camera(scene, aspect) : scene.cameras.front();
  } else if (options.camera == "frame") {
    camera = framing_camera(scene, aspect);
  } else if (const auto index = find_named(scene.cameras, options.camera)) {
    camera = scene.cameras[*index];
  } else if (const auto parsed = parse_camera(options.camera, scene)) {
    camera = *parsed;
  } else {
    fail_usage("--camera {}: valid: 'frame', 'x,y,z:x,y,z' (eye and target in metres), or a camera of the scene: {}",
               options.camera, names_of(scene.cameras));
  }
  if (settings.was_set("camera.vertical_fov") && camera.orthographic)
    fail_usage("--set camera.vertical_fov=...: the camera is orthographic");
  if (settings.was_set("camera.vertical_fov")) camera.vertical_fov = radians(settings.block("camera").number("vertical_fov"));
  if (settings.was_set("camera.near")) camera.near = static_cast<float>(settings.block("camera").number("near"));
  settings.set_effective("camera", "vertical_fov", degrees(camera.vertical_fov));
  settings.set_effective("camera", "near", camera.near);
  return camera;
}

std::vector<Light> choose_lights(const Scene& scene, const ViewOptions& options, const Settings& settings) {
  std::vector<Light> lights;
  if (options.lights.empty()) {
    const auto sun = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [](const Light& light) { return light.kind == LightKind::directional; });
    // Lamps light a scene by themselves; a sun is invented only for one that has no light at all.
    if (sun != scene.lights.end()) {
      lights.push_back(*sun);
    } else if (!scene.lights.empty()) {
      lights = scene.lights;
    } else {
      lights.push_back(default_sun(settings));
    }
  }
  for (const std::string& text : options.lights) {
    if (const auto index = find_named(scene.lights, text)) {
      lights.push_back(scene.lights[*index]);
    } else if (text == "all" && !scene.lights.empty()) {
      lights.insert(lights.end(), scene.lights.begin(), scene.lights.end());
    } else if (text == "sun") {
      lights.push_back(default_sun(settings));
    } else if (const auto light = parse_light(text)) {
      lights.push_back(*light);
    } else {
      fail_usage("--light {}: valid: 'sun' (placed by the light settings), {}a light of the scene: {}; or {}", text,
                 scene.lights.empty() ? "" : "'all', ", names_of(scene.lights), k_light_text_help);
    }
  }
  name_apart(lights);
  for (const char* key : {"light.azimuth", "light.elevation", "light.angular_diameter"}) {
    const bool any_sun =
        std::any_of(lights.begin(), lights.end(), [](const Light& light) { return light.kind == LightKind::directional; });
    if (settings.was_set(key) && !any_sun) fail_usage("--set {}=...: no chosen light is directional", key);
  }
  for (Light& light : lights) override_light(light, settings);
  return lights;
}

CameraPath choose_camera_path(const Scene& scene, const std::string& text) {
  const auto index = find_named(scene.camera_paths, text);
  if (!index && text.ends_with(".json")) return read_camera_path(text);
  if (!index) fail_usage("--path {}: valid: a .json file of a path, {}", text, names_of(scene.camera_paths));
  return scene.camera_paths[*index];
}

SunMotion choose_sun_path(const Scene& scene, const std::string& text) {
  const auto index = find_named(scene.sun_paths, text);
  if (!index && text.ends_with(".json")) return read_sun_path(text);
  if (!index) fail_usage("--sun-path {}: valid: a .json file of a sun's path, {}", text, names_of(scene.sun_paths));
  return scene.sun_paths[*index];
}

}  // namespace gnomon
