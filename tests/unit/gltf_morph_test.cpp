// glTF: morph targets, from generated files.
#include "scene/gltf/gltf_morph.h"

#include <gtest/gtest.h>

#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

TEST(GltfMorph, AddsEachTargetByItsWeight) {
  MeshPart part;
  part.positions = {{0, 0, 0}, {1, 0, 0}};
  part.normals = {{0, 0, 1}, {0, 0, 1}};
  part.tangents = {{1, 0, 0, -1}, {1, 0, 0, -1}};
  const std::vector<MorphTarget> targets = {
      {.positions = {{0, 1, 0}, {0, 2, 0}}, .normals = {}, .tangents = {}},
      {.positions = {{0, 0, 4}, {0, 0, 8}}, .normals = {{1, 0, -1}, {0, 0, 0}}, .tangents = {{0, 0, 2}, {0, 0, 0}}},
      {.positions = {{9, 9, 9}, {9, 9, 9}}, .normals = {}, .tangents = {}}};
  morph(part, targets, std::vector<float>{2.0f, 0.5f});  // the third target has no weight
  EXPECT_EQ(part.positions[0], vec3(0, 2, 2));
  EXPECT_EQ(part.positions[1], vec3(1, 4, 4));
  EXPECT_EQ(part.normals[0], vec3(0.5f, 0, 0.5f));
  EXPECT_EQ(part.normals[1], vec3(0, 0, 1));
  EXPECT_EQ(part.tangents[0], vec4(1, 0, 1, -1)) << "handedness is not a direction";
}

// A triangle whose two targets lift its last corner by 1 and by 10.
GltfBuilder lifted(const json& mesh_more = json::object()) {
  GltfBuilder b;
  const json target0 = {{"POSITION", b.positions({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}})}},
             target1 = {{"POSITION", b.positions({{0, 0, 0}, {0, 0, 0}, {0, 10, 0}})}};
  b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}}, -1, {{"targets", {target0, target1}}});
  b.root["meshes"][0].update(mesh_more);
  b.node({{"mesh", 0}});
  return b;
}

float top(const Scene& scene) { return scene.bounds().max.y; }

TEST(GltfMorph, WeightsOfTheAnimationGoBeforeTheNodesAndTheMeshs) {
  EXPECT_EQ(top(lifted().load()), 1.0f) << "weights are 0 unless a file says otherwise";
  GltfBuilder b = lifted({{"weights", {0.5, 0}}});
  EXPECT_EQ(top(b.load()), 1.5f);
  b.root["nodes"][0]["weights"] = {0, 0.25};
  EXPECT_EQ(top(b.load()), 3.5f);
  b.root["animations"] = {{{"samplers", {{{"input", b.numbers({0, 1})}, {"output", b.numbers({0, 0, 1, 2})}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
  EXPECT_EQ(top(b.load()), 1.0f) << "at 0 s";
  SceneFileOptions half;
  half.params.time = 0.5f;
  EXPECT_EQ(top(b.load(half)), 1.0f + 0.5f + 10.0f);
  b.root["animations"][0]["samplers"][0]["output"] = b.numbers({0, 0, 1});
  EXPECT_TRUE(b.error().starts_with("test.gltf: animations[0].samplers[0].output: has 3 elements")) << b.error();
}

TEST(GltfMorph, NodesOfDifferentWeightsHaveMeshesOfTheirOwn) {
  GltfBuilder b = lifted({{"weights", {1, 0}}});
  b.node({{"mesh", 0}, {"weights", {0, 1}}});
  b.node({{"mesh", 0}, {"weights", {1, 0}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.objects.at(0).mesh, scene.objects.at(2).mesh) << "the same shape is shared";
  EXPECT_EQ(scene.meshes[0].bounds().max.y, 2.0f);
  EXPECT_EQ(scene.meshes[1].bounds().max.y, 11.0f);
}

TEST(GltfMorph, SparseTargetsAndNormals) {
  GltfBuilder b;
  const int sparse =
      b.add("accessors", {{"type", "VEC3"},
                          {"componentType", test_files::k_float},
                          {"count", 3},
                          {"sparse",
                           {{"count", 1},
                            {"indices", {{"bufferView", b.view_of(std::vector<uint16_t>{2})}, {"componentType", 5123}}},
                            {"values", {{"bufferView", b.view_of(std::vector<vec3>{{0, 0, 3}})}}}}}});
  const int normals = b.positions({{0, 0, 0}, {0, 0, 0}, {3, 0, 0}});
  b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
          {"NORMAL", b.positions(std::vector<vec3>(3, vec3(0, 0, 1)))}},
         -1, {{"targets", {{{"POSITION", sparse}, {"NORMAL", normals}}}}});
  b.node({{"mesh", 0}, {"weights", {1}}});
  const Scene scene = b.load();
  const MeshPart& part = scene.meshes.at(0).parts.at(0);
  bool found = false;
  for (size_t i = 0; i < 3; ++i) {
    if (part.positions[i] != vec3(0, 1, 3)) continue;
    found = true;
    EXPECT_LT(glm::distance(part.normals[i], glm::normalize(vec3(3, 0, 1))), 1e-6f) << "made unit again";
  }
  EXPECT_TRUE(found);
}

TEST(GltfMorph, NormalsOfAFileWithoutThemAreThoseOfTheShape) {
  GltfBuilder b;
  b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}}, -1,
         {{"targets", {{{"POSITION", b.positions({{0, 0, 0}, {0, 0, 0}, {0, -1, 1}})}}}}});
  b.node({{"mesh", 0}, {"weights", {1}}});
  EXPECT_LT(glm::distance(b.load().meshes.at(0).parts.at(0).normals[0], vec3(0, -1, 0)), 1e-6f);
}

TEST(GltfMorph, WhatDoesNotFitIsSaid) {
  GltfBuilder b = lifted({{"weights", {1, 0, 0}}});
  {
    const WarningWatch watch;
    EXPECT_EQ(top(b.load()), 2.0f);
    ASSERT_EQ(watch.texts().size(), 1u);
    EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: meshes[0]: has 3 weights for 2 morph targets")) << watch.texts()[0];
  }
  b.root["meshes"][0]["weights"] = {1, 0};
  b.root["meshes"][0]["primitives"][0]["targets"][0]["TEXCOORD_0"] = 0;
  {
    const WarningWatch watch;
    b.load();
    ASSERT_EQ(watch.texts().size(), 1u);
    EXPECT_TRUE(watch.texts()[0].find("texture coordinates") != std::string::npos) << watch.texts()[0];
  }
  b.root["meshes"][0]["primitives"][0]["targets"][0] = {{"POSITION", b.positions({{0, 1, 0}})}};
  EXPECT_TRUE(b.error().starts_with("test.gltf: meshes[0].primitives[0].targets[0].POSITION: has 1 elements")) << b.error();
}

TEST(GltfMorph, ShapesBeyondFloatsAreRefused) {
  GltfBuilder b = lifted({{"weights", {3e38, 3e38}}});
  EXPECT_TRUE(b.error().starts_with("test.gltf: meshes[0].primitives[0]: the pose moves vertex 2 ")) << b.error();
}

}  // namespace
}  // namespace gnomon
