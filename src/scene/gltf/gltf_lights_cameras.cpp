// Lights and cameras of a glTF file, before nodes place them.
#include "scene/gltf/gltf_lights_cameras.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

Camera read_gltf_camera(const GltfValue& json) {
  Camera camera;
  camera.name = json.text("name", "");
  const std::string type = json.text("type", "");
  constexpr double k_least = 1e-6;
  if (type == "perspective") {
    const GltfValue lens = json.required_object("perspective");
    camera.vertical_fov = static_cast<float>(lens.required_number("yfov", k_least, 3.14159));
    camera.near = static_cast<float>(lens.required_number("znear", k_least, 1e30));
    camera.far = static_cast<float>(lens.number("zfar", 0.0, 0.0));
    lens.number("aspectRatio", 1.0, k_least);
    if (lens.has("zfar") && camera.far <= camera.near)
      lens.fail_in("zfar", "is {}; valid: beyond znear, {}", camera.far, camera.near);
  } else if (type == "orthographic") {
    const GltfValue lens = json.required_object("orthographic");
    camera.orthographic = true;
    camera.half_height = static_cast<float>(std::abs(lens.required_number("ymag", -k_any, k_any)));
    if (camera.half_height == 0.0f) lens.fail_in("ymag", "is 0; valid: half the height of the view");
    camera.near = static_cast<float>(lens.required_number("znear", 0.0, k_any));
    camera.far = static_cast<float>(lens.required_number("zfar", 0.0, k_any));
    if (camera.far <= camera.near) lens.fail_in("zfar", "is {}; valid: beyond znear, {}", camera.far, camera.near);
  } else {
    json.fail_in("type", "is \"{}\"; valid: perspective, orthographic", type);
  }
  return camera;
}

Light read_gltf_light(const GltfValue& json) {
  Light light;
  light.name = json.text("name", "");
  const std::string type = json.text("type", "");
  if (type == "directional") {
    light.kind = LightKind::directional;
  } else if (type == "point") {
    light.kind = LightKind::point;
  } else if (type == "spot") {
    light.kind = LightKind::spot;
    const GltfValue cone = json.required_object("spot");
    light.outer_cone = std::min(static_cast<float>(cone.number("outerConeAngle", k_pi / 4.0, 1e-6, 1.5709)), 0.5f * k_pi);
    light.inner_cone = static_cast<float>(cone.number("innerConeAngle", 0.0, 0.0, 1.5709));
    if (light.inner_cone > light.outer_cone) {
      cone.fail_in("innerConeAngle", "is {}; valid: at most outerConeAngle, {}", light.inner_cone, light.outer_cone);
    }
  } else {
    json.fail_in("type", "is \"{}\"; valid: directional, point, spot", type);
  }
  light.colour = json.vector<3>("color", vec3(1.0f));
  if (glm::any(glm::lessThan(light.colour, vec3(0.0f)))) json.fail_in("color", "valid: 0 or more");
  light.intensity = static_cast<float>(json.number("intensity", 1.0, 0.0));
  light.range = static_cast<float>(json.number("range", 0.0, 0.0));
  return light;
}

}  // namespace gnomon
