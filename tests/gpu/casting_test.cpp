// Which casters count - by name, by material, by alpha - is the same for every map, every path that draws it, and for rays:
// the same receivers lie in shadow as the CPU reference says.
#include "scene/casting.h"

#include "frame/casters/caster_draws.h"
#include "reference/cpu/embree_reference.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

constexpr uvec2 k_size = {64, 48};

// Four panes above a floor: one casts where its blended picture is solid, one through the holes of its cut-out, one as a whole,
// and one of glass not at all.
Scene panes() {
  Scene scene = test::scene_with(
      {test::floor_part(2.5f), test::floor_part(0.6f), test::floor_part(0.6f), test::floor_part(0.6f), test::floor_part(0.6f)});
  const char* objects[] = {"ground", "leaf pane", "net pane", "solid pane", "glass pane"};
  const char* materials[] = {"soil", "leaf", "net", "paint", "glass"};
  scene.materials.resize(5, scene.materials[0]);
  for (size_t i = 0; i < 5; ++i) {
    scene.objects[i].name = objects[i], scene.materials[i].name = materials[i];
    scene.meshes[i].parts[0].material = static_cast<int>(i);
    scene.materials[i].double_sided = true;
    if (i > 0) {
      const vec3 at(i % 2 == 0 ? 0.9f : -0.9f, 0.7f, i > 2 ? 0.9f : -0.9f);
      scene.objects[i].world_from_object = glm::translate(mat4(1.0f), at);
    }
  }
  Texture ramp, columns;
  ramp.image = columns.image = Image8(16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      ramp.image.at(x, y)[3] = static_cast<uint8_t>(17 * x);
      columns.image.at(x, y)[3] = x / 4 % 2 == 0 ? 255 : 0;
    }
  }
  ramp.wrap_u = ramp.wrap_v = columns.wrap_u = columns.wrap_v = Wrap::clamp;
  scene.textures = {ramp, columns};
  Material &leaf = scene.materials[1], &net = scene.materials[2];
  leaf.blended = leaf.half_casts = true;
  leaf.base_colour.w = 0.8f, leaf.base_colour_texture = 0;  // solid from 5/8 of the ramp on
  net.masked = true, net.base_colour_texture = 1;
  scene.materials[4].blended = true, scene.materials[4].casts = false;
  scene.cameras.push_back(look_at("above", {0.5f, 6, 2.0f}, {0, 0, 0}, 50.0));
  return scene;
}

Light lamp_of(LightKind kind) {
  Light light = test::make_sun({-0.2f, -1, 0.15f});
  light.kind = kind;
  if (kind == LightKind::directional) return light;
  light.position = {0.15f, 3, 0.1f}, light.intensity = 10.0f, light.range = 8.0f;
  light.direction = {0, -1, 0}, light.outer_cone = 0.8f;
  return light;
}

struct Run {
  std::string_view technique, small_maps;
};

std::vector<Run> runs_of(LightKind kind) {
  if (kind == LightKind::directional) return {{"single/hard", "single.size=512"}, {"cascaded/hard", "cascaded.size=512"}};
  if (kind == LightKind::spot) return {{"single/hard", "single.size=512"}};
  return {{"cube/hard", "cube.size=512"}, {"dual_paraboloid/hard", "dual_paraboloid.size=512"}};
}

// Receivers whose neighbours have the same answer: an edge may lie a texel of the map beside.
std::vector<size_t> inner_points(const ReferenceResult& reference) {
  std::vector<size_t> result;
  for (size_t y = 1; y + 1 < k_size.y; ++y) {
    for (size_t x = 1; x + 1 < k_size.x; ++x) {
      const size_t i = y * k_size.x + x;
      bool inner = true;
      for (const size_t row : {i - k_size.x, i, i + k_size.x}) {
        for (const size_t k : {row - 1, row, row + 1})
          inner = inner && reference.receiver[k] && reference.visibility[k] == reference.visibility[i];
      }
      if (inner) result.push_back(i);
    }
  }
  return result;
}

void expect_like_reference(const std::vector<float>& mask, const ReferenceResult& reference, const std::string& what) {
  const std::vector<size_t> points = inner_points(reference);
  ASSERT_GT(points.size(), mask.size() / 4) << what;
  size_t different = 0;
  for (const size_t i : points) different += std::abs(mask[i] - reference.visibility[i]) > 0.5f;
  EXPECT_LE(different, points.size() / 200) << what << ": of " << points.size();
}

// How many receivers are dark to the reference; every technique that serves the light must agree.
size_t shadowed(LightKind kind, const std::vector<std::string>& rules) {
  Scene scene = panes();
  scene.lights = {lamp_of(kind)};
  apply_casting(scene, rules);
  View view(std::move(scene), k_size);
  view.draw();
  const ReferenceResult reference =
      EmbreeReference(view.scene())
          .trace(view.frame().read_points(), view.frame().camera().eye_ws, view.scene().lights[0], false, 1, 1);
  const std::string what = fmt::format("{} {}", light_kind_name(kind), fmt::join(rules, " "));
  const auto& rays = find_technique("ray_traced");
  if (device().info().ray_tracing)
    expect_like_reference(test::run_technique(view, rays, rays.default_settings()).mask, reference, what + " ray_traced");
  for (const Run& run : runs_of(kind)) {
    const TechniqueSpec& spec = find_technique(run.technique);
    for (const auto path :
         {LayeringPath::per_layer, LayeringPath::vertex_layer, LayeringPath::geometry, LayeringPath::multiview}) {
      if (!layering_path_missing(device().info(), path).empty()) continue;
      const std::string path_setting = fmt::format("submission.path={}", layering_path_name(path));
      const SettingsMap settings = test::settings_of(spec, {run.small_maps, path_setting});
      expect_like_reference(test::run_technique(view, spec, settings).mask, reference,
                            fmt::format("{} {} {}", what, run.technique, path_setting));
    }
  }
  size_t dark = 0;
  for (size_t i = 0; i < reference.visibility.size(); ++i) dark += reference.receiver[i] && reference.visibility[i] == 0.0f;
  return dark;
}

void expect_the_named_cast(LightKind kind) {
  const size_t plain = shadowed(kind, {});
  EXPECT_LT(shadowed(kind, {"leaf=off"}), plain) << "a material whose picture decides";
  EXPECT_LT(shadowed(kind, {"net pane=off", "solid pane=off"}), plain) << "objects";
  EXPECT_GT(shadowed(kind, {"glass=on"}), plain) << "glass";
  const size_t one = shadowed(kind, {"*=off", "leaf=on"});
  EXPECT_GT(one, 0u) << "the last rule counts";
  EXPECT_LT(one, plain);
  EXPECT_EQ(shadowed(kind, {"*=off"}), 0u) << "nothing casts, and all is lit";
}

TEST(CastingOnGpu, Sun) { expect_the_named_cast(LightKind::directional); }
TEST(CastingOnGpu, Point) { expect_the_named_cast(LightKind::point); }
TEST(CastingOnGpu, Spot) { expect_the_named_cast(LightKind::spot); }

}  // namespace
}  // namespace gnomon
