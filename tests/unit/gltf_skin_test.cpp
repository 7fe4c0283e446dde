// glTF: skins, from generated files.
#include "scene/gltf/gltf_skin.h"

#include <gtest/gtest.h>

#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

mat4 moved(const vec3& by) { return glm::translate(mat4(1.0f), by); }

TEST(GltfSkin, BlendsTheJointsLinearly) {
  MeshPart part;
  part.positions = {{1, 0, 0}, {1, 0, 0}};
  part.normals = {{1, 1, 0}, {1, 0, 0}};
  part.tangents = {{1, -1, 0, 1}, {0, 1, 0, 1}};
  part.indices = {0, 1, 0};
  const SkinInfluences influences{.per_vertex = 2, .joints = {0, 1, 1, 99}, .weights = {0.25f, 0.75f, 1.0f, 0.0f}};
  const std::vector<mat4> joints = {moved({0, 4, 0}), glm::scale(moved({0, 0, 8}), vec3(2, 1, 1))};
  EXPECT_FALSE(apply_skin(part, influences, joints)) << "joint 99 has no weight";
  EXPECT_EQ(part.positions[0], vec3(1.75f, 1, 6));
  EXPECT_EQ(part.positions[1], vec3(2, 0, 8));
  EXPECT_LT(glm::distance(glm::normalize(part.normals[0]), glm::normalize(vec3(1, 1.75f, 0))), 1e-6f) << "inverse transpose";
  EXPECT_LT(std::abs(glm::dot(part.normals[0], vec3(part.tangents[0]))), 1e-5f) << "tangents stay in the surface";
  EXPECT_EQ(part.indices, (std::vector<uint32_t>{0, 1, 0}));
}

TEST(GltfSkin, AJointThatIsNotThereIsFound) {
  MeshPart part;
  part.positions = {{1, 2, 3}, {4, 5, 6}};
  const SkinInfluences influences{.per_vertex = 1, .joints = {0, 1}, .weights = {1, 1}};
  EXPECT_EQ(apply_skin(part, influences, std::vector<mat4>{moved({1, 0, 0})}), std::optional<size_t>(1));
  EXPECT_EQ(part.positions[0], vec3(1, 2, 3));
}

TEST(GltfSkin, WeightsSumUpToOne) {
  SkinInfluences influences{.per_vertex = 2, .joints = {0, 1, 0, 1}, .weights = {1, 3, 0, 0}};
  EXPECT_EQ(normalise(influences), 1u);
  EXPECT_EQ(influences.weights, (std::vector<float>{0.25f, 0.75f, 1, 0}));
}

// A strip of two squares along y, carried by the joints "hip" (at the origin) and "knee" (1 above it, its child); the node of
// the mesh stands elsewhere.
struct Leg {
  GltfBuilder b;
  json attributes;
  Leg() {
    const std::vector<vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
    const std::vector<uint8_t> joints = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const std::vector<vec4> weights = {{1, 0, 0, 0},       {1, 0, 0, 0}, {0.5f, 0.5f, 0, 0},
                                       {0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    attributes = {{"POSITION", b.positions(corners)},
                  {"JOINTS_0", b.accessor(joints, "VEC4", test_files::k_ubyte, 6)},
                  {"WEIGHTS_0", b.vec4s(weights)}};
    b.mesh(attributes, b.indices({0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
    b.node({{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}});
    b.node({{"name", "hip"}, {"children", {2}}});
    b.add("nodes", {{"name", "knee"}, {"translation", {0, 1, 0}}});
    b.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", b.matrices({moved({0, 0, 0}), moved({0, -1, 0})})}}};
  }
};

bool has_vertex(const Scene& scene, const vec3& at) {
  for (const vec3& p : scene.meshes.at(0).parts.at(0).positions) {
    if (glm::distance(vec3(scene.objects.at(0).world_from_object * vec4(p, 1)), at) < 1e-5f) return true;
  }
  return false;
}

TEST(GltfSkin, JointsCarryTheVerticesWhereverTheNodeStands) {
  Leg leg;
  EXPECT_EQ(leg.b.load().bounds().max, vec3(1, 2, 0)) << "the bind pose";
  const float half = std::sqrt(0.5f);
  leg.b.root["nodes"][2]["rotation"] = {half, 0, 0, half};  // the knee bends: up becomes toward +z
  Scene scene = leg.b.load();
  EXPECT_TRUE(has_vertex(scene, {1, 0, 0}));
  EXPECT_TRUE(has_vertex(scene, {1, 1, 0}));
  EXPECT_TRUE(has_vertex(scene, {1, 1, 1})) << "the end follows the knee";
  leg.b.root["nodes"][1]["translation"] = {0, 0, 7};
  scene = leg.b.load();
  EXPECT_TRUE(has_vertex(scene, {0, 1, 8})) << "and the knee the hip";
}

TEST(GltfSkin, AnimatedJoints) {
  Leg leg;
  GltfBuilder& b = leg.b;
  b.root["animations"] = {{{"samplers", {{{"input", b.numbers({0, 1})}, {"output", b.positions({{0, 1, 0}, {0, 5, 0}})}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}};
  EXPECT_EQ(b.load().bounds().max.y, 2.0f);
  SceneFileOptions options;
  options.params.time = 0.5f;
  const Scene scene = b.load(options);
  EXPECT_EQ(scene.bounds().max.y, 4.0f);
  EXPECT_TRUE(has_vertex(scene, {0, 2, 0})) << "halfway between both joints";
}

TEST(GltfSkin, MoreThanFourJoints) {
  Leg leg;
  GltfBuilder& b = leg.b;
  // The second set moves half of each vertex's weight to joint 1.
  const std::vector<uint16_t> joints(24, 1);
  const std::vector<uint8_t> weights = {0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0};
  leg.attributes["JOINTS_1"] = b.accessor(joints, "VEC4", test_files::k_ushort, 6);
  leg.attributes["WEIGHTS_1"] = b.accessor(weights, "VEC4", test_files::k_ubyte, 6, true);
  b.root["meshes"][0]["primitives"][0]["attributes"] = leg.attributes;
  b.root["nodes"][2]["translation"] = {0, 1, 8};
  const Scene scene = b.load();
  EXPECT_TRUE(has_vertex(scene, {0, 0, 4})) << "half of it follows the second set";
  EXPECT_TRUE(has_vertex(scene, {0, 1, 6}));
  EXPECT_TRUE(has_vertex(scene, {0, 2, 8}));
}

TEST(GltfSkin, MirroredSkeletonsKeepTheirFront) {
  Leg leg;
  const vec3 normal = leg.b.load().meshes.at(0).parts.at(0).normals[0];
  EXPECT_EQ(normal, vec3(0, 0, 1));
  leg.b.root["nodes"][1]["scale"] = {-1, 1, 1};
  const Scene scene = leg.b.load();
  EXPECT_EQ(scene.bounds().min.x, -1.0f);
  for (const vec3& n : scene.meshes.at(0).parts.at(0).normals) EXPECT_EQ(n, vec3(0, 0, 1));
}

// A mirror turns the handedness of tangent and bitangent around: without it normal maps would bend the light the other way.
TEST(GltfSkin, MirroredSkinsTurnTheHandednessOfTheirTangents) {
  const SkinInfluences influences{.per_vertex = 1, .joints = {0, 0, 0}, .weights = {1, 1, 1}};
  for (const float side : {1.0f, -1.0f}) {
    MeshPart part;
    part.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    part.normals.assign(3, {0, 0, 1});
    part.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {1, 0, 0, 1}};
    part.indices = {0, 1, 2};
    const std::vector<vec4> before = part.tangents;
    EXPECT_FALSE(apply_skin(part, influences, std::vector<mat4>{glm::scale(mat4(1.0f), vec3(side, 1, 1))}));
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(vec3(part.tangents[i]), vec3(side, 0, 0));
      EXPECT_EQ(part.tangents[i].w, side * before[i].w);
      // The bitangent lies where the skin carries the old one.
      const vec3 bitangent = glm::cross(glm::normalize(part.normals[i]), vec3(part.tangents[i])) * part.tangents[i].w;
      EXPECT_EQ(bitangent, vec3(0, before[i].w, 0)) << i;
    }
  }
}

// Rounding leaves last rows as (0, 0, 1e-3, 0.999): they would pull vertices toward the origin.
TEST(GltfSkin, InverseBindMatricesAreAffine) {
  Leg leg;
  mat4 hip(1.0f), knee = moved({0, -1, 0});
  hip[2].w = 0.25f, hip[3].w = 0.5f, knee[0].w = -0.125f, knee[3].w = 2.0f;
  leg.b.root["skins"][0]["inverseBindMatrices"] = leg.b.matrices({hip, knee});
  leg.b.root["nodes"][1]["translation"] = {3, 0, 0};
  const Scene scene = leg.b.load();
  EXPECT_EQ(scene.bounds().min, vec3(3, 0, 0));
  EXPECT_EQ(scene.bounds().max, vec3(4, 2, 0));
}

// Vertices that no triangle has are left out where the file is read: messages count as the file does.
TEST(GltfSkin, MessagesNumberVerticesAsTheFileDoes) {
  Leg leg;
  leg.b.root["meshes"][0]["primitives"][0]["indices"] = leg.b.indices({2, 3, 4, 3, 5, 4});  // without 0 and 1
  json& skin = leg.b.root["skins"][0];
  const json joints = skin["joints"];
  skin["joints"] = {1};
  EXPECT_NE(leg.b.error().find("a joint of vertex 2 is not among the 1"), std::string::npos) << leg.b.error();
  skin["joints"] = joints;
  leg.b.root["nodes"][2]["scale"] = {3e38, 3e38, 3e38};
  leg.b.root["nodes"][1]["scale"] = {3e38, 3e38, 3e38};
  EXPECT_NE(leg.b.error().find("meshes[0].primitives[0]: the pose moves vertex 2 "), std::string::npos) << leg.b.error();
}

TEST(GltfSkin, DamageIsReportedWithItsPlace) {
  const auto error_with = [](const std::function<void(Leg&)>& damage) {
    Leg leg;
    damage(leg);
    return leg.b.error();
  };
  const auto attribute = [](Leg& leg, const char* name) -> json& {
    return leg.b.root["meshes"][0]["primitives"][0]["attributes"][name];
  };
  const std::string primitive = "test.gltf: meshes[0].primitives[0].attributes";
  EXPECT_TRUE(error_with([](Leg& l) {
                l.b.root["skins"][0]["joints"] = {1};
              }).starts_with(primitive + ".JOINTS_n: a joint of vertex "));
  EXPECT_TRUE(error_with([](Leg& l) {
                l.b.root["skins"][0]["joints"] = {1, 9};
              }).starts_with("test.gltf: skins[0].joints[1]: "));
  EXPECT_TRUE(
      error_with([](Leg& l) { l.b.root["skins"][0]["joints"] = json::array(); }).starts_with("test.gltf: skins[0].joints: "));
  EXPECT_TRUE(error_with([](Leg& l) {
                l.b.root["skins"][0]["joints"] = {1, 2, 2};
              }).starts_with("test.gltf: skins[0].inverseBindMatrices: has 2 matrices"));
  EXPECT_TRUE(error_with([](Leg& l) {
                l.b.root["skins"][0]["inverseBindMatrices"] = 0;
              }).starts_with("test.gltf: skins[0].inverseBindMatrices: "));
  EXPECT_TRUE(error_with([](Leg& l) { l.b.root["nodes"][0]["skin"] = 1; }).starts_with("test.gltf: nodes[0].skin: "));
  EXPECT_TRUE(
      error_with([&](Leg& l) { attribute(l, "JOINTS_0") = attribute(l, "WEIGHTS_0"); }).starts_with(primitive + ".JOINTS_0: "));
  EXPECT_TRUE(error_with([](Leg& l) {
                l.b.root["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
              }).starts_with(primitive + ": has JOINTS_0 without WEIGHTS_0"));
}

TEST(GltfSkin, WithoutJointsOrWeightsItIsSaid) {
  Leg leg;
  leg.b.root["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", leg.attributes["POSITION"]}};
  const WarningWatch watch;
  EXPECT_EQ(leg.b.load().bounds().max, vec3(101, 102, 100)) << "placed like any other";
  ASSERT_EQ(watch.texts().size(), 1u);
  EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: nodes[0]: has a skin, but meshes[0].primitives[0] names no joints"))
      << watch.texts()[0];

  Leg half;
  json second = half.b.root["meshes"][0]["primitives"][0];
  second["attributes"].erase("JOINTS_0"), second["attributes"].erase("WEIGHTS_0");
  half.b.root["meshes"][0]["primitives"].push_back(second);
  EXPECT_EQ(half.b.load().bounds().max, vec3(101, 102, 100));
  ASSERT_EQ(watch.texts().size(), 2u);
  EXPECT_TRUE(watch.texts()[1].starts_with("test.gltf: nodes[0]: has a skin, but meshes[0].primitives[1] names no joints"))
      << watch.texts()[1];

  Leg loose;
  loose.attributes["WEIGHTS_0"] = loose.b.vec4s(std::vector<vec4>(6, vec4(0.0f)));
  loose.b.root["meshes"][0]["primitives"][0]["attributes"] = loose.attributes;
  loose.b.load();
  ASSERT_EQ(watch.texts().size(), 3u);
  EXPECT_TRUE(watch.texts()[2].find("6 vertices have no weights") != std::string::npos) << watch.texts()[2];
}

}  // namespace
}  // namespace gnomon
