// The axis of a file that points up: everything turns with it, and a hint where it may be another.
#include "scene/finish_file_scene.h"

#include <gtest/gtest.h>

#include "base/log.h"
#include "gltf_builder.h"

namespace gnomon {
namespace {

using namespace scene_file_params;

SceneFileOptions with_up(uint32_t up) {
  SceneFileOptions options;
  options.params.up = up;
  options.given = {"up"};
  return options;
}

TEST(UpAxis, ThatAxisPointsUpAndNothingIsMirrored) {
  const std::pair<uint32_t, vec3> axes[] = {{up_y, {0, 1, 0}}, {up_z, {0, 0, 1}}, {up_x, {1, 0, 0}}, {up_minus_z, {0, 0, -1}}};
  for (const auto& [up, axis] : axes) {
    Scene scene;
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    scene.meshes.emplace_back();
    finish_file_scene(scene, with_up(up));
    const mat3 turn(scene.objects[0].world_from_object);
    EXPECT_EQ(turn * axis, vec3(0, 1, 0)) << up;
    EXPECT_EQ(glm::determinant(turn), 1.0f) << up;
    EXPECT_EQ(turn * glm::transpose(turn), mat3(1.0f)) << up;
  }
}

// z up: a pole from (1, 2, 0) to (1, 2, 3).
constexpr const char* k_pole = "o pole\nv 1 2 0\nv 1.1 2 0\nv 1 2 3\nf 1 2 3\n";

TEST(UpAxis, Obj) {
  const Box box = load_obj_from_memory(k_pole, "pole.obj", {}, with_up(up_z)).bounds();
  EXPECT_LT(glm::distance(box.min, vec3(1, 0, -2)), 1e-6f);
  EXPECT_LT(glm::distance(box.max, vec3(1.1f, 3, -2)), 1e-6f);
}

TEST(UpAxis, GltfWithLightAndCamera) {
  test_files::GltfBuilder b;
  b.triangle();
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
  b.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  b.node({{"translation", {1, 2, 3}},
          {"camera", 0},
          {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});  // both look along -Z of the file
  const std::string text = b.gltf();
  const Scene scene = load_gltf_from_memory(std::as_bytes(std::span(text)), "test.gltf", {}, with_up(up_z));
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].direction, vec3(0, -1, 0)) << "down";
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(vec3(scene.cameras[0].world_from_view[3]), vec3(1, 3, -2));
  EXPECT_EQ(-vec3(scene.cameras[0].world_from_view[2]), vec3(0, -1, 0));
  EXPECT_EQ(scene.bounds().max, vec3(1, 0, 0));
  EXPECT_EQ(scene.bounds().min, vec3(0, 0, -1)) << "the file's y";
}

TEST(UpAxis, LampsTurnWithTheirPlaces) {
  Scene scene;
  scene.materials.emplace_back();
  for (const LightKind kind : {LightKind::point, LightKind::spot}) {
    Light lamp;
    lamp.kind = kind;
    lamp.position = {1, 2, 3};
    lamp.direction = {0, 0, -1};
    scene.lights.push_back(lamp);
  }
  finish_file_scene(scene, with_up(up_z));
  for (const Light& lamp : scene.lights) EXPECT_EQ(lamp.position, vec3(1, 3, -2));
  EXPECT_EQ(scene.lights[1].direction, vec3(0, -1, 0));
}

std::string hint_of(const vec3& size, const SceneFileOptions& options = {}) {
  const std::string text = fmt::format("v 0 0 0\nv {} 0 0\nv 0 {} 0\nv 0 0 {}\nf 1 2 3\nf 1 2 4\n", size.x, size.y, size.z);
  testing::internal::CaptureStderr();
  load_obj_from_memory(text, "model.obj", {}, options);
  return testing::internal::GetCapturedStderr();
}

TEST(UpAxis, AHintWhereAModelMayLieOnItsBack) {
  EXPECT_NE(hint_of({100, 80, 10}).find("--up z"), std::string::npos) << hint_of({100, 80, 10});
  EXPECT_NE(hint_of({10, 80, 100}).find("--up x"), std::string::npos);
  for (const vec3& size : {vec3(100, 10, 100), vec3(100, 0, 100), vec3(10, 100, 10), vec3(3, 100, 3), vec3(10, 10, 10),
                           vec3(100, 8, 10), vec3(1.2f, 1.8f, 0.4f), vec3(1.7f, 1.8f, 0.3f)})
    EXPECT_EQ(hint_of(size).find("--up"), std::string::npos) << size.x << " " << size.y << " " << size.z;
  EXPECT_EQ(hint_of({100, 80, 10}, with_up(up_y)).find("--up"), std::string::npos) << "it was said";
}

}  // namespace
}  // namespace gnomon
