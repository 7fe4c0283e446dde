// Memory that runs out while a scene is loaded or the CPU traces it: an error, or a whole result, never a half.
#include <gtest/gtest.h>

#include "gltf_builder.h"
#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"
#include "scene_files.h"
#include "support/failing_allocation.h"

namespace gnomon {
namespace {

using namespace test;
using test_files::GltfBuilder;
using test_files::json;

uint64_t hash_of(const Scene& scene) { return std::stoull(scene.content_hash(), nullptr, 16); }

std::array<uint8_t, 4> holes(int x, int y) { return {200, 100, 50, static_cast<uint8_t>((x / 4 + y / 4) % 2 == 0 ? 255 : 0)}; }

TEST(WithoutMemory, AnObjIsLoadedWholeOrNotAtAll) {
  const test_files::Folder folder;
  folder.picture("Leaf.PNG", 16, 16, holes);
  write_file(folder.path() / "a.mtl", "newmtl leaf\nKd 1 1 1\nmap_Kd leaf.png\nnewmtl pane\nKd 0.2 0.3 0.4\nd 0.3\n");
  write_file(folder.path() / "a.obj",
             "mtllib A.mtl\no first\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0.5\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl leaf\n"
             "f 1/1 2/2 3/3 4/1\no second\nusemtl pane\nf 1 2 4\nl 1 2\n");
  try_without_memory(
      "obj", [&] { return hash_of(load_scene((folder.path() / "a.obj").string())); }, 160);
}

TEST(WithoutMemory, AGltfIsLoadedWholeOrNotAtAll) {
  const test_files::Folder folder;
  folder.picture("leaf.png", 16, 16, holes);
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                           {"TEXCOORD_0", b.uvs({{0, 0}, {1, 0}, {0, 1}})},
                           {"JOINTS_0", b.accessor(std::vector<uint8_t>(12, 0), "VEC4", test_files::k_ubyte, 3)},
                           {"WEIGHTS_0", b.vec4s({{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}})}};
  b.root["images"] = {{{"uri", "leaf.png"}}};
  b.root["textures"] = {{{"source", 0}}};
  b.root["materials"] = {
      {{"name", "leaf"}, {"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  b.mesh(attributes, b.indices({0, 1, 2}),
         {{"material", 0}, {"targets", {{{"POSITION", b.positions({{0, 0, 1}, {0, 0, 0}, {0, 0, 0}})}}}}});
  b.root["meshes"][0]["weights"] = {0.5};
  b.node({{"name", "leaf"}, {"mesh", 0}, {"skin", 0}});
  b.node({{"name", "joint"}});
  b.root["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", b.matrices({mat4(1.0f)})}}};
  b.root["animations"] = {
      {{"samplers",
        {{{"input", b.numbers({0, 1})},
          {"output", b.accessor(std::vector<vec3>{{0, 0, 0}, {0, 2, 0}}, "VEC3", test_files::k_float, 2)}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  SceneFileOptions options;
  options.params.time = 0.5;
  write_file(folder.path() / "a.gltf", b.gltf());
  // A document of nlohmann's library takes memory to go away, and ends the process where there is none: that comes last.
  std::optional<json> document = json::parse(b.gltf());
  const size_t at_the_end = count_allocations([&] { document.reset(); });
  try_without_memory(
      "gltf", [&] { return hash_of(load_scene((folder.path() / "a.gltf").string(), {}, options)); }, 200, at_the_end);
}

TEST(WithoutMemory, ABuiltInSceneIsMadeWholeOrNotAtAll) {
  try_without_memory(
      "chart/sphere", [] { return hash_of(load_scene("chart/sphere")); }, 60);
}

TEST(WithoutMemory, TheCpuTracesAllOrNothing) {
  Scene scene = empty_scene();
  add(scene, floor_quad(10.0f));
  add(scene, box(vec3(-1, 1, -1), vec3(1, 2, 1)));
  Light light = sun({0.5f, -1.0f, 0.0f});
  light.angular_diameter = 0.05f;
  std::vector<SurfacePoint> points;
  for (int i = -40; i <= 40; ++i) points.push_back(floor_point(0.1f * static_cast<float>(i), 0));
  const auto trace = [&] {
    const ReferenceResult result = EmbreeReference(scene).trace(points, vec3(0, 10, 0), light, true, 16, 7);
    return mixed(mixed(0, result.visibility), result.receiver);
  };
  try_without_memory("reference", trace, 100);
}

}  // namespace
}  // namespace gnomon
