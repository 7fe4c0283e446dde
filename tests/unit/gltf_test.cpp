// glTF: geometry, hierarchy, instances, lights and cameras, from generated files.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "base/file.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;
using test_files::k_byte;
using test_files::k_float;
using test_files::k_short;
using test_files::k_ubyte;
using test_files::k_uint;
using test_files::k_ushort;

const std::vector<vec3> k_corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

const MeshPart& only_part(const Scene& scene) {
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes.at(0).parts.size(), 1u);
  return scene.meshes.at(0).parts.at(0);
}

// The vertex at a position, whatever order optimise() chose.
size_t vertex_at(const MeshPart& part, const vec3& position) {
  for (size_t i = 0; i < part.positions.size(); ++i) {
    if (glm::distance(part.positions[i], position) < 1e-4f) return i;
  }
  ADD_FAILURE() << "no vertex there";
  return 0;
}

TEST(Gltf, QuadWithEverything) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions(k_corners)},
                           {"NORMAL", b.positions({{0, 0, 1}, {0, 0, 1}, {0, 0, 2}, {0, 0, 1}})},
                           {"TANGENT", b.vec4s({{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}})},
                           {"TEXCOORD_0", b.uvs({{0, 1}, {1, 1}, {1, 0}, {0, 0}})},
                           {"COLOR_0", b.vec4s({{1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 1, 0.5f}, {1, 0, 0, 1}})}};
  b.node({{"name", "the node"}, {"mesh", b.mesh(attributes, b.indices({0, 1, 2, 0, 2, 3}))}});
  const Scene scene = b.load();
  EXPECT_EQ(scene.name, "test.gltf");
  EXPECT_EQ(scene.objects.at(0).name, "the node");
  EXPECT_EQ(scene.materials.size(), 1u);
  const MeshPart& part = only_part(scene);
  ASSERT_EQ(part.positions.size(), 4u);
  ASSERT_EQ(part.triangle_count(), 2u);
  EXPECT_NEAR(test_files::area(part), 1.0, 1e-6);
  const size_t i = vertex_at(part, {1, 1, 0});
  EXPECT_EQ(part.uvs[i], vec2(1, 0));
  EXPECT_EQ(part.colours[i], vec4(0, 0, 1, 0.5f));
  EXPECT_EQ(part.normals[i], vec3(0, 0, 1)) << "made unit";
  EXPECT_EQ(part.tangents[i], vec4(1, 0, 0, 1));
}

TEST(Gltf, TextBinaryAndExternalBufferAreTheSame) {
  test_files::Folder folder;
  GltfBuilder b;
  b.triangle();
  const std::string expected = b.load().content_hash();
  EXPECT_EQ(load_gltf_from_memory(b.glb(), "x.glb", {}).content_hash(), expected);
  json external = b.root;
  external["buffers"][0] = {{"byteLength", b.data.size()}, {"uri", "a%20buffer.bin"}};
  write_file(folder.path() / "a buffer.bin", b.data);
  EXPECT_EQ(GltfBuilder::load_text(external.dump(), folder.path()).content_hash(), expected);
  EXPECT_THROW(GltfBuilder::load_text(external.dump()), Error);
  write_file(folder.path() / "scene.glb", b.glb());
  const Scene scene = load_scene((folder.path() / "scene.glb").string());
  EXPECT_EQ(scene.name, "scene.glb");
  EXPECT_EQ(scene.content_hash(), expected);
}

TEST(Gltf, QuantisedAndInterleavedAttributes) {
  GltfBuilder b;
  // position (short, 6 bytes + 2 padding), normal (byte, 3 + 1), uv (ushort, 4): one view, stride 16.
  struct Vertex {
    int16_t position[4];
    int8_t normal[4];
    uint16_t uv[2];
  };
  static_assert(sizeof(Vertex) == 16);
  const std::vector<Vertex> vertices = {{{0, 0, 0, 0}, {0, 0, 127, 0}, {0, 65535}},
                                        {{32767, 0, 0, 0}, {0, 0, 127, 0}, {65535, 65535}},
                                        {{0, -32768, 0, 0}, {0, 0, 127, 0}, {0, 0}}};
  const int view = b.view(std::as_bytes(std::span(vertices)), 16);
  const auto accessor = [&](int offset, const char* type, int component, bool normalised) {
    return b.add("accessors", {{"bufferView", view},
                               {"byteOffset", offset},
                               {"type", type},
                               {"componentType", component},
                               {"normalized", normalised},
                               {"count", 3}});
  };
  const json attributes = {{"POSITION", accessor(0, "VEC3", k_short, true)},
                           {"NORMAL", accessor(8, "VEC3", k_byte, true)},
                           {"TEXCOORD_0", accessor(12, "VEC2", k_ushort, true)}};
  b.node({{"mesh", b.mesh(attributes, b.accessor(std::vector<uint8_t>{0, 2, 1}, "SCALAR", k_ubyte, 3))}, {"scale", {2, 2, 2}}});
  b.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const Scene scene = b.load();
  const MeshPart& part = only_part(scene);
  EXPECT_EQ(part.positions[vertex_at(part, {1, 0, 0})], vec3(1, 0, 0));
  EXPECT_EQ(part.positions[vertex_at(part, {0, -1, 0})], vec3(0, -1, 0)) << "-32768 is -1, not below";
  EXPECT_EQ(part.uvs[vertex_at(part, {1, 0, 0})], vec2(1, 1));
  EXPECT_EQ(part.normals[0], vec3(0, 0, 1));
  EXPECT_EQ(scene.bounds().max.x, 2.0f);

  GltfBuilder whole;
  const std::vector<uint8_t> bytes = {0, 0, 0, 0, 200, 0, 0, 0, 0, 100, 0, 0};
  whole.node({{"mesh", whole.mesh({{"POSITION", whole.accessor(bytes, "VEC3", k_ubyte, 3, false, 4)}})}});
  EXPECT_EQ(whole.load().bounds().max, vec3(200, 100, 0)) << "integers that are not normalised keep their value";
}

TEST(Gltf, ColoursOfThreeBytes) {
  GltfBuilder b;
  const std::vector<uint8_t> colours = {255, 0, 0, 0, 0, 255, 0, 0, 51, 51, 51, 0};
  b.node({{"mesh", b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                           {"COLOR_0", b.accessor(colours, "VEC3", k_ubyte, 3, true, 4)}})}});
  const MeshPart part = only_part(b.load());
  EXPECT_EQ(part.colours[vertex_at(part, {1, 0, 0})], vec4(0, 1, 0, 1));
  EXPECT_NEAR(part.colours[vertex_at(part, {0, 1, 0})].x, 0.2f, 1e-6f);
}

TEST(Gltf, IndexWidthsStripsAndFans) {
  const auto area_of = [](const json& more, const std::function<int(GltfBuilder&)>& indices, const std::vector<vec3>& corners) {
    GltfBuilder b;
    const int positions = b.positions(corners);
    b.node({{"mesh", b.mesh({{"POSITION", positions}}, indices(b), more)}});
    const Scene scene = b.load();
    for (const MeshPart& part : scene.meshes.at(0).parts) {
      for (const vec3& n : part.normals) EXPECT_NEAR(n.z, 1.0f, 1e-6f) << "winding is kept";
    }
    return test_files::area(scene);
  };
  const auto none = [](GltfBuilder&) { return -1; };
  EXPECT_NEAR(area_of(
                  json::object(),
                  [](GltfBuilder& b) {
                    return b.accessor(std::vector<uint32_t>{0, 1, 2, 0, 2, 3}, "SCALAR", k_uint, 6);
                  },
                  k_corners),
              1, 1e-6);
  EXPECT_NEAR(area_of(
                  json::object(),
                  [](GltfBuilder& b) {
                    return b.accessor(std::vector<uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR", k_ubyte, 6);
                  },
                  k_corners),
              1, 1e-6);
  EXPECT_NEAR(area_of(json::object(), none, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1, 1e-6);
  const std::vector<vec3> zigzag = {{0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {2, 1, 0}, {2, 0, 0}};
  EXPECT_NEAR(area_of({{"mode", 5}}, none, zigzag), 2, 1e-6);
  EXPECT_NEAR(area_of(
                  {{"mode", 5}},
                  [](GltfBuilder& b) {
                    return b.indices({0, 1, 2, 3});
                  },
                  zigzag),
              1, 1e-6);
  EXPECT_NEAR(area_of({{"mode", 6}}, none, k_corners), 1, 1e-6);
  EXPECT_NEAR(area_of(
                  {{"mode", 6}},
                  [](GltfBuilder& b) {
                    return b.indices({1, 2, 3, 0});
                  },
                  k_corners),
              1, 1e-6);
}

TEST(Gltf, PointsAndLinesAreLeftOut) {
  GltfBuilder b;
  b.triangle();
  const int positions = b.positions(k_corners);
  for (int mode = 0; mode < 4; ++mode) b.node({{"mesh", b.mesh({{"POSITION", positions}}, -1, {{"mode", mode}})}});
  b.node({{"mesh", b.mesh({{"NORMAL", positions}})}});
  const Scene scene = b.load();
  EXPECT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.triangle_count(), 1u);
}

TEST(Gltf, SparseAccessors) {
  GltfBuilder b;
  const int base = b.positions(k_corners);
  const int index_view = b.view_of(std::vector<uint16_t>{1, 2});
  const int value_view = b.view_of(std::vector<vec3>{{5, 0, 0}, {5, 1, 0}});
  const json sparse = {{"count", 2},
                       {"indices", {{"bufferView", index_view}, {"componentType", k_ushort}}},
                       {"values", {{"bufferView", value_view}}}};
  b.root["accessors"][static_cast<size_t>(base)]["sparse"] = sparse;
  const int from_zero = b.add("accessors", {{"componentType", k_float}, {"type", "VEC3"}, {"count", 4}, {"sparse", sparse}});
  b.node({{"mesh", b.mesh({{"POSITION", base}}, b.indices({0, 1, 2, 0, 2, 3}))}});
  b.node({{"mesh", b.mesh({{"POSITION", from_zero}}, b.indices({0, 1, 2}))}});
  const Scene scene = b.load();
  EXPECT_NEAR(test_files::area(scene.meshes.at(0).parts.at(0)), 5.0, 1e-5);
  EXPECT_NEAR(test_files::area(scene.meshes.at(1).parts.at(0)), 2.5, 1e-5);

  // Sparse indices: the second triangle appears only through them.
  GltfBuilder s;
  const int positions = s.positions(k_corners), indices = s.indices({0, 1, 2, 0, 0, 0});
  const json changed = {{"count", 2},
                        {"indices", {{"bufferView", s.view_of(std::vector<uint8_t>{4, 5})}, {"componentType", k_ubyte}}},
                        {"values", {{"bufferView", s.view_of(std::vector<uint16_t>{2, 3})}}}};
  s.root["accessors"][static_cast<size_t>(indices)]["sparse"] = changed;
  s.node({{"mesh", s.mesh({{"POSITION", positions}}, indices)}});
  EXPECT_NEAR(test_files::area(only_part(s.load())), 1.0, 1e-6);
}

TEST(Gltf, OnlyUsedVerticesAreKept) {
  GltfBuilder b;
  std::vector<vec3> many(1000, vec3(7.0f));
  many[500] = {0, 0, 0}, many[700] = {1, 0, 0}, many[900] = {0, 1, 0};
  b.node({{"mesh", b.mesh({{"POSITION", b.positions(many)}}, b.indices({500, 700, 900}))}});
  const Scene scene = b.load();
  EXPECT_EQ(only_part(scene).positions.size(), 3u);
  EXPECT_EQ(scene.bounds().max, vec3(1, 1, 0));
}

TEST(Gltf, MissingNormalsAndTangentsAreMade) {
  GltfBuilder b;
  b.node({{"mesh", b.mesh({{"POSITION", b.positions(k_corners)}, {"TEXCOORD_0", b.uvs({{0, 1}, {1, 1}, {1, 0}, {0, 0}})}},
                          b.indices({0, 1, 2, 0, 2, 3}))}});
  const MeshPart part = only_part(b.load());
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(part.normals[i], vec3(0, 0, 1));
    EXPECT_EQ(part.tangents[i], vec4(1, 0, 0, 1));
    EXPECT_EQ(part.colours[i], vec4(1.0f));
  }
  GltfBuilder zero;
  zero.node({{"mesh",
              zero.mesh({{"POSITION", zero.positions(k_corners)}, {"NORMAL", zero.positions(std::vector<vec3>(4, vec3(0.0f)))}},
                        zero.indices({0, 1, 2, 0, 2, 3}))}});
  EXPECT_EQ(only_part(zero.load()).normals[0], vec3(0, 0, 1)) << "normals of length zero are mended";
}

// --- hierarchy ---

TEST(Gltf, TransformsMultiplyDownTheTree) {
  GltfBuilder b;
  const int mesh = b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  const float half = std::sqrt(0.5f);
  // Root: moved; child: turned by 90 degrees about z; grandchild: a matrix that scales by 2 and moves along x.
  b.add("nodes", {{"name", "leaf"}, {"mesh", mesh}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1}}});
  b.add("nodes", {{"rotation", {0, 0, half, half}}, {"children", {0}}, {"mesh", mesh}});
  b.node({{"translation", {10, 20, 30}}, {"children", {1}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.objects.size(), 2u);
  ASSERT_EQ(scene.meshes.size(), 1u) << "the mesh is shared";
  EXPECT_EQ(scene.objects[1].name, "leaf");
  const vec3 tip = vec3(scene.objects[1].world_from_object * vec4(1, 0, 0, 1));
  EXPECT_LT(glm::distance(tip, vec3(10, 23, 30)), 1e-5f);
  EXPECT_LT(glm::distance(vec3(scene.objects[0].world_from_object * vec4(1, 0, 0, 1)), vec3(10, 21, 30)), 1e-5f);
}

TEST(Gltf, MirroredNodesShareTheirMesh) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions(k_corners)},
                           {"NORMAL", b.positions(std::vector<vec3>(4, vec3(0, 0, 1)))},
                           {"TEXCOORD_0", b.uvs({{0, 1}, {1, 1}, {1, 0}, {0, 0}})}};
  const int mesh = b.mesh(attributes, b.indices({0, 1, 2, 0, 2, 3}));
  b.node({{"mesh", mesh}});
  b.node({{"mesh", mesh}, {"scale", {-1, 1, 1}}});
  b.node({{"mesh", mesh}, {"scale", {-1, -1, 1}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.meshes.size(), 1u) << "what draws and traces turns the front round where the transform mirrors";
  for (const Object& object : scene.objects) {
    const MeshPart& part = scene.meshes[static_cast<size_t>(object.mesh)].parts[0];
    const glm::mat3 m(object.world_from_object);
    const float side = glm::determinant(m) < 0.0f ? -1.0f : 1.0f;  // as frame/gpu_scene.cpp and surface.vert
    for (size_t t = 0; t < part.triangle_count(); ++t) {
      const uint32_t* i = &part.indices[3 * t];
      const vec3 n =
          glm::cross(m * (part.positions[i[1]] - part.positions[i[0]]), m * (part.positions[i[2]] - part.positions[i[0]]));
      EXPECT_GT(side * n.z, 0.0f);
      const vec3 top = glm::cross(m * part.normals[i[0]], m * vec3(part.tangents[i[0]])) * (side * part.tangents[i[0]].w);
      EXPECT_GT(glm::dot(top, m * vec3(0, 1, 0)), 0.0f) << "the bitangent points to the top of the picture";
    }
  }
}

TEST(Gltf, TheDefaultSceneIsTaken) {
  GltfBuilder b;
  b.triangle();
  b.add("nodes", {{"mesh", 0}, {"translation", {5, 0, 0}}});
  b.root["scenes"].push_back({{"nodes", {1}}});
  EXPECT_EQ(b.load().bounds().min.x, 0.0f);
  b.root["scene"] = 1;
  EXPECT_EQ(b.load().bounds().min.x, 5.0f);
  b.root.erase("scene");
  EXPECT_EQ(b.load().bounds().min.x, 0.0f) << "the first one";
  b.root.erase("scenes");
  EXPECT_EQ(b.load().objects.size(), 2u) << "without scenes: every node";
}

TEST(Gltf, DeepChainsAreNoProblem) {
  GltfBuilder b;
  const int mesh = b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  constexpr int k_depth = 50000;
  for (int i = 0; i < k_depth; ++i) b.add("nodes", {{"children", {i + 1}}, {"translation", {0, 0, 1}}});
  b.add("nodes", {{"mesh", mesh}});
  b.root["scenes"] = {{{"nodes", {0}}}};
  EXPECT_EQ(b.load().bounds().min.z, static_cast<float>(k_depth));
}

TEST(Gltf, ExtrasSayWhetherANodeCasts) {
  GltfBuilder b;
  const int mesh = b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  b.node({{"mesh", mesh}});
  b.node({{"mesh", mesh}, {"extras", {{"casts_shadow", false}}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_TRUE(scene.objects[0].casts);
  EXPECT_FALSE(scene.objects[1].casts);
}

TEST(Gltf, GpuInstancing) {
  GltfBuilder b;
  const int mesh = b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  const float half = std::sqrt(0.5f);
  const json attributes = {{"TRANSLATION", b.positions({{0, 0, 0}, {10, 0, 0}, {0, 0, 5}})},
                           {"ROTATION", b.vec4s({{0, 0, 0, 1}, {0, 0, half, half}, {0, 0, 0, 1}})},
                           {"SCALE", b.positions({{1, 1, 1}, {2, 2, 2}, {-1, 1, 1}})}};
  b.node({{"name", "tree"},
          {"mesh", mesh},
          {"translation", {0, 100, 0}},
          {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
  b.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const Scene scene = b.load();
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[1].name, "tree[1]");
  EXPECT_LT(glm::distance(vec3(scene.objects[1].world_from_object * vec4(1, 0, 0, 1)), vec3(10, 102, 0)), 1e-5f);
  EXPECT_LT(glm::distance(vec3(scene.objects[2].world_from_object * vec4(1, 0, 0, 1)), vec3(-1, 100, 5)), 1e-5f);
  EXPECT_EQ(scene.objects[2].mesh, scene.objects[0].mesh) << "the mirrored instance shares its mesh";

  GltfBuilder packed;
  packed.triangle();
  const std::vector<int8_t> rotations = {0, 0, 0, 127, 0, 0, 127, 0};
  packed.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] =
      packed.accessor(rotations, "VEC4", k_byte, 2, true);
  const Scene turned = packed.load();
  ASSERT_EQ(turned.objects.size(), 2u);
  EXPECT_LT(glm::distance(vec3(turned.objects[1].world_from_object * vec4(1, 0, 0, 1)), vec3(-1, 0, 0)), 1e-5f);
}

// --- lights and cameras ---

TEST(Gltf, Lights) {
  GltfBuilder b;
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"name", "sun"}, {"color", {1, 0.5, 0.25}}, {"intensity", 9}},
      {{"type", "point"}, {"range", 12}},
      {{"type", "spot"}, {"intensity", 3}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
      {{"type", "spot"}, {"spot", json::object()}}};
  const float half = std::sqrt(0.5f);
  const auto light = [](int index) { return json{{"KHR_lights_punctual", {{"light", index}}}}; };
  b.node({{"name", "sun node"}, {"rotation", {-half, 0, 0, half}}, {"scale", {3, 3, 3}}, {"extensions", light(0)}});
  b.node({{"translation", {1, 2, 3}}, {"extensions", light(1)}});
  b.node({{"translation", {0, 5, 0}}, {"extensions", light(2)}});
  b.node({{"extensions", light(3)}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[0].name, "sun node");
  EXPECT_LT(glm::distance(scene.lights[0].direction, vec3(0, -1, 0)), 1e-6f) << "down its own -z";
  EXPECT_EQ(scene.lights[0].colour, vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(scene.lights[0].intensity, 9.0f);
  EXPECT_EQ(scene.lights[1].kind, LightKind::point);
  EXPECT_EQ(scene.lights[1].name, "point 1") << "kind, and number on the command line, where nothing has a name";
  EXPECT_EQ(scene.lights[3].name, "spot 3");
  EXPECT_EQ(scene.lights[1].position, vec3(1, 2, 3));
  EXPECT_EQ(scene.lights[1].range, 12.0f);
  EXPECT_EQ(scene.lights[1].intensity, 1.0f);
  EXPECT_EQ(scene.lights[2].kind, LightKind::spot);
  EXPECT_EQ(scene.lights[2].direction, vec3(0, 0, -1));
  EXPECT_EQ(scene.lights[2].inner_cone, 0.25f);
  EXPECT_EQ(scene.lights[2].outer_cone, 0.5f);
  EXPECT_EQ(scene.lights[3].inner_cone, 0.0f);
  EXPECT_NEAR(scene.lights[3].outer_cone, k_pi / 4, 1e-6f);
  EXPECT_EQ(scene.lights[3].range, 0.0f) << "unlimited";
}

TEST(Gltf, Cameras) {
  GltfBuilder b;
  b.triangle();
  b.root["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.2}, {"zfar", 50}, {"aspectRatio", 1.5}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}},
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.5}}}}};
  const float half = std::sqrt(0.5f);
  b.node({{"name", "eye"}, {"camera", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, half, 0, half}}, {"scale", {2, 2, 2}}});
  b.node({{"camera", 1}});
  b.node({{"camera", 2}, {"translation", {0, 0, 1000}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.cameras.size(), 3u);
  const Camera& eye = scene.cameras[0];
  EXPECT_EQ(eye.name, "eye");
  EXPECT_FALSE(eye.orthographic);
  EXPECT_EQ(eye.vertical_fov, 0.7f);
  EXPECT_EQ(eye.near, 0.2f);
  EXPECT_EQ(eye.far, 50.0f);
  EXPECT_LT(glm::distance(vec3(eye.world_from_view[3]), vec3(1, 2, 3)), 1e-6f);
  EXPECT_LT(glm::distance(-vec3(eye.world_from_view[2]), vec3(-1, 0, 0)), 1e-6f) << "looks along its -z, without the scale";
  EXPECT_TRUE(scene.cameras[1].orthographic);
  EXPECT_EQ(scene.cameras[1].name, "camera 1");
  EXPECT_EQ(scene.cameras[1].half_height, 2.0f);
  EXPECT_GT(scene.cameras[2].far, 1000.0f) << "an infinite projection ends behind the scene";
  EXPECT_LT(scene.cameras[2].far, 1100.0f);
}

// Nothing may look at all materials, skins or nodes for each of as many meshes or nodes: that took a minute.
TEST(Gltf, ManyThousandMaterialsSkinsAndNodesLoadInSeconds) {
  constexpr int k_many = 16000;
  GltfBuilder b;
  const int corners = b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const json joints = {{"POSITION", corners},
                       {"JOINTS_0", b.accessor(std::vector<uint8_t>(12, 0), "VEC4", test_files::k_ubyte, 3)},
                       {"WEIGHTS_0", b.vec4s(std::vector<vec4>(3, vec4(1, 0, 0, 0)))}};
  const int skinned = b.mesh(joints);
  json scene = json::array();
  for (int i = 0; i < k_many; ++i) {
    b.add("materials", {{"name", fmt::format("m{}", i)}});
    const int mesh = b.mesh({{"POSITION", corners}}, -1, {{"material", i}});
    b.add("skins", {{"joints", {3 * i}}});
    for (const json& node : {json{{"translation", {i, 0, 0}}}, json{{"mesh", mesh}}, json{{"mesh", skinned}, {"skin", i}}})
      scene.push_back(b.add("nodes", node));
  }
  b.root["scenes"] = {{{"nodes", scene}}};
  const std::string text = b.gltf();
  const auto start = std::chrono::steady_clock::now();
  const Scene loaded = GltfBuilder::load_text(text);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(loaded.objects.size(), size_t{2} * k_many);
  EXPECT_EQ(loaded.bounds().max.x, static_cast<float>(k_many));
  EXPECT_LT(time.count(), 10.0);
}

}  // namespace
}  // namespace gnomon
