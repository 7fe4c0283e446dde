// The scenes of the conformance tests.
#include "stage.h"

#include <algorithm>
#include <map>

#include "scene/light_shape.h"

namespace gnomon::test {

LightKind preferred_light(const TechniqueSpec& spec) {
  for (const LightKind kind : {LightKind::directional, LightKind::spot, LightKind::point}) {
    if (spec.supports(kind)) return kind;
  }
  fail("{} supports no light", spec.name);
}

Light make_light(LightKind kind, const vec3& direction, const vec3& target, float distance) {
  Light light = make_sun(direction);
  light.kind = kind;
  if (kind == LightKind::directional) return light;
  light.position = target - distance * light.direction;
  light.beam_radius = 12.0f;
  if (kind == LightKind::projector) return light;
  light.intensity = 30.0f;
  light.inner_cone = 0.7f, light.outer_cone = 0.9f;
  return light;
}

Scene open_floor(LightKind kind) {
  Scene scene = scene_with({floor_part(10.0f), box_part({6, 0, -1}, {7, 1.5f, 1})});
  scene.cameras.push_back(look_at("beside", {-2, 4, 5}, {-2, 0, 0}, 50.0));
  scene.lights.push_back(make_light(kind, {0.5f, -1, 0.2f}, {-1, 0, 0}, 9.0f));
  return scene;
}

Scene closed_room(LightKind kind, bool thin) {
  const vec3 low(-2, 0, -2), high(2, 3, 2);
  std::vector<MeshPart> parts;
  if (thin) {
    parts.push_back(box_part(low, high));
  } else {
    const float w = 0.5f;
    parts.push_back(box_part({low.x - w, low.y - w, low.z - w}, {high.x + w, low.y, high.z + w}));
    parts.push_back(box_part({low.x - w, high.y, low.z - w}, {high.x + w, high.y + w, high.z + w}));
    parts.push_back(box_part({low.x - w, low.y, low.z - w}, {low.x, high.y, high.z + w}));
    parts.push_back(box_part({high.x, low.y, low.z - w}, {high.x + w, high.y, high.z + w}));
    parts.push_back(box_part({low.x, low.y, low.z - w}, {high.x, high.y, low.z}));
    parts.push_back(box_part({low.x, low.y, high.z}, {high.x, high.y, high.z + w}));
  }
  Scene scene = scene_with(std::move(parts));
  scene.materials[0].double_sided = true;
  scene.cameras.push_back(look_at("within", {-1.7f, 2.5f, -1.7f}, {1, 0.6f, 1}, 85.0));
  scene.lights.push_back(make_light(kind, {0.5f, -1, 0.3f}, {0, 1, 0}, 9.0f));
  return scene;
}

Scene box_on_floor(LightKind kind) {
  Scene scene = scene_with({floor_part(6.0f), box_part({-0.7f, 0.4f, -0.7f}, {0.7f, 1.4f, 0.7f})});
  scene.cameras.push_back(look_at("above", {3, 5, 4}, {0.4f, 0, 0}, 50.0));
  scene.lights.push_back(make_light(kind, {0.5f, -1, 0.2f}, {0, 0, 0}, 7.0f));
  return scene;
}

Scene busy(LightKind kind) {
  if (kind == LightKind::directional) return load_scene("courtyard");
  std::vector<MeshPart> parts = {floor_part(6.0f)};
  for (int i = 0; i < 9; ++i) {
    const vec3 at(-2.0f + 2.0f * static_cast<float>(i % 3), 0.3f + 0.2f * static_cast<float>(i),
                  -2.0f + 2.0f * static_cast<float>(i / 3));
    parts.push_back(box_part(at - vec3(0.4f), at + vec3(0.4f)));
  }
  Scene scene = scene_with(std::move(parts));
  scene.cameras.push_back(look_at("above", {4, 5, 5}, {0, 0.5f, 0}, 50.0));
  scene.lights.push_back(make_light(kind, {0.4f, -1, 0.2f}, {0, 0, 0}, 7.0f));
  return scene;
}

View& kept_view(const std::string& name, const std::function<Scene()>& make, uvec2 size, uint32_t samples) {
  static std::map<std::string, std::unique_ptr<View>> views;
  if (views.empty()) at_exit([] { views.clear(); });
  const std::string key = fmt::format("{} {}x{} {}", name, size.x, size.y, samples);
  auto& view = views[key];
  if (!view) view = std::make_unique<View>(make(), size, samples);
  return *view;
}

std::vector<uint8_t> receivers(View& view) {
  const LightShape shape = light_shape(view.scene().lights[0], false);
  std::vector<uint8_t> flags;
  for (const SurfacePoint& point : view.frame().read_points()) {
    flags.push_back(point.object != k_no_object && receives_light(shape, point.position_ws, point.geometric_normal_ws));
  }
  return flags;
}

size_t count(const std::vector<uint8_t>& flags) {
  return static_cast<size_t>(std::count(flags.begin(), flags.end(), uint8_t{1}));
}

const ReferenceResult& hard_reference(View& view) {
  static std::map<const View*, ReferenceResult> results;
  const auto [found, inserted] = results.try_emplace(&view);
  if (inserted) {
    view.draw();
    const auto points = view.frame().read_points();
    found->second =
        EmbreeReference(view.scene()).trace(points, view.frame().camera().eye_ws, view.scene().lights[0], false, 1, 1);
  }
  return found->second;
}

std::string test_name(std::string_view text) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

}  // namespace gnomon::test
