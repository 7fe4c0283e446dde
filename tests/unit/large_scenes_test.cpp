// town, landscape, hexworld, lamps: what their descriptions promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "scene/load.h"
#include "scene/path.h"

namespace gnomon {
namespace {

const std::vector<std::pair<std::string, std::map<std::string, double>>> k_small = {
    {"town", {{"detail", 0.02}}},
    {"landscape", {{"detail", 0.02}}},
    {"hexworld", {{"radius", 30}, {"detail", 0.1}}},
    {"lamps", {}}};

// Objects whose mesh another object has too.
size_t instances(const Scene& scene) {
  std::map<int, size_t> uses;
  for (const Object& object : scene.objects) ++uses[object.mesh];
  size_t count = 0;
  for (const auto& [mesh, times] : uses) count += times > 1 ? times : 0;
  return count;
}

size_t lights_of(const Scene& scene, LightKind kind) {
  return static_cast<size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(), [&](const Light& l) { return l.kind == kind; }));
}

bool has_foliage(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.masked && m.double_sided; });
}

TEST(large_scenes, town_is_the_published_load) {
  const Scene scene = load_scene("town");
  EXPECT_NEAR(static_cast<double>(scene.objects.size()), 1000.0, 20.0);
  EXPECT_GE(instances(scene), 500u);
  EXPECT_GE(scene.triangle_count(), 950000u);
  EXPECT_LE(scene.triangle_count(), 1100000u);
  EXPECT_EQ(lights_of(scene, LightKind::directional), 1u);
  EXPECT_TRUE(has_foliage(scene));
  // Casters behind the first viewer, and a street that ends beyond a kilometre.
  const Camera& camera = scene.cameras.front();
  const vec3 eye(camera.world_from_view[3]), back(camera.world_from_view[2]);
  float tallest_behind = 0.0f, farthest = 0.0f;
  for (const Object& object : scene.objects) {
    const Box box = transformed(object.world_from_object, scene.meshes[static_cast<size_t>(object.mesh)].bounds());
    if (glm::dot(box.centre() - eye, back) > 5.0f && box.max.y < 100.0f) tallest_behind = std::max(tallest_behind, box.max.y);
    if (object.name.starts_with("house")) farthest = std::max(farthest, glm::length(box.centre() - eye));
  }
  EXPECT_GT(tallest_behind, 40.0f);
  EXPECT_GT(farthest, 1100.0f);
}

TEST(large_scenes, landscape_is_four_kilometres_under_several_suns) {
  const Scene scene = load_scene("landscape", {{"detail", 0.02}});
  EXPECT_GE(scene.bounds().extent().x, 4000.0f);
  EXPECT_GE(scene.bounds().extent().z, 4000.0f);
  EXPECT_EQ(lights_of(scene, LightKind::directional), 3u);
  ASSERT_EQ(lights_of(scene, LightKind::projector), 1u);
  EXPECT_GT(instances(scene), 1000u);
  EXPECT_TRUE(has_foliage(scene));
  std::set<std::string> names;
  for (const Light& light : scene.lights) names.insert(light.name);
  EXPECT_EQ(names.size(), 4u);
}

TEST(large_scenes, hexworld_has_a_roofed_cave_and_a_gorge) {
  const Scene scene = load_scene("hexworld", {{"radius", 40}, {"detail", 0.1}});
  EXPECT_TRUE(has_foliage(scene));
  bool roof = false, deep = false;
  for (const Mesh& mesh : scene.meshes) {
    if (!mesh.name.starts_with("columns")) continue;
    for (const MeshPart& part : mesh.parts) {
      for (size_t i = 0; i < part.positions.size(); ++i) {
        roof = roof || (part.normals[i].y < -0.5f && part.positions[i].y > 4.0f);  // a ceiling
        deep = deep || (part.normals[i].y > 0.5f && part.positions[i].y < -9.0f);  // a floor
      }
    }
  }
  EXPECT_TRUE(roof);
  EXPECT_TRUE(deep);
  EXPECT_EQ(scene.cameras.at(1).name, "cave");
}

TEST(large_scenes, lamps_has_a_light_of_each_kind_but_no_sun) {
  const Scene scene = load_scene("lamps");
  EXPECT_EQ(lights_of(scene, LightKind::directional), 0u);
  EXPECT_EQ(lights_of(scene, LightKind::point), 1u);
  EXPECT_EQ(lights_of(scene, LightKind::spot), 1u);
  EXPECT_EQ(lights_of(scene, LightKind::projector), 1u);
  int ranged = 0;
  for (const Light& light : scene.lights) {
    EXPECT_TRUE(light.parallel() || light.radius > 0.0f) << light.name;
    ranged += light.range > 0.0f ? 1 : 0;
    const Box room = scene.bounds();
    EXPECT_TRUE(glm::all(glm::greaterThan(light.position, room.min)) && glm::all(glm::lessThan(light.position, room.max)))
        << light.name;
  }
  EXPECT_EQ(ranged, 1);
}

TEST(large_scenes, are_valid_the_same_twice_and_named_once) {
  for (const auto& [name, options] : k_small) {
    const Scene scene = load_scene(name, options);  // checks it
    EXPECT_EQ(scene.content_hash(), load_scene(name, options).content_hash()) << name;
    EXPECT_EQ(scene.cameras.front().name, "default");
    EXPECT_GE(scene.cameras.size(), 2u);
    EXPECT_LE(scene.cameras.size(), 4u);
    std::set<std::string> names;
    for (const Object& object : scene.objects) EXPECT_TRUE(names.insert(object.name).second) << name << ' ' << object.name;
    for (const Mesh& mesh : scene.meshes) {
      for (const MeshPart& part : mesh.parts) {
        size_t against = 0;
        for (size_t i = 0; i < part.indices.size(); i += 3) {
          const auto corner = [&](size_t k) { return glm::dvec3(part.positions[part.indices[i + k]]); };
          const glm::dvec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
          for (size_t k = 0; k < 3; ++k) against += glm::dot(face, glm::dvec3(part.normals[part.indices[i + k]])) < 0.0 ? 1 : 0;
        }
        // Smooth normals of a coarse hillside may turn away from one of its steepest faces; a wrong winding is all of them.
        EXPECT_LE(against, part.indices.size() / 100) << name << ' ' << mesh.name << ": normals against the winding";
      }
    }
  }
}

TEST(large_scenes, detail_scales_triangles_and_nothing_else) {
  for (const char* name : {"town", "landscape"}) {
    const Scene small = load_scene(name, {{"detail", 0.05}}), large = load_scene(name, {{"detail", 0.5}});
    EXPECT_EQ(small.objects.size(), large.objects.size()) << name;
    EXPECT_LT(2 * small.triangle_count(), large.triangle_count()) << name;
    EXPECT_THROW(load_scene(name, {{"detail", 0.001}}), Error);
    EXPECT_THROW(load_scene(name, {{"detail", 5.0}}), Error);
  }
}

TEST(large_scenes, built_in_scenes_have_paths_and_charts_none) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const bool chart = builtin.name.starts_with("chart/");
    std::map<std::string, double> options;
    for (const BuiltinOption& option : builtin.options) {
      if (option.name == "detail") options["detail"] = option.min;
    }
    const Scene scene = load_scene(builtin.name, options);
    std::vector<std::string> names;
    for (const CameraPath& path : scene.camera_paths) names.push_back(path.name);
    EXPECT_EQ(names, chart ? std::vector<std::string>{} : (std::vector<std::string>{"walk", "turn", "fly"})) << builtin.name;
    ASSERT_EQ(scene.sun_paths.size(), chart ? 0u : 1u) << builtin.name;
    Scene still = scene;
    still.camera_paths.clear(), still.sun_paths.clear();
    EXPECT_EQ(still.content_hash(), scene.content_hash()) << builtin.name;
  }
}

}  // namespace
}  // namespace gnomon
