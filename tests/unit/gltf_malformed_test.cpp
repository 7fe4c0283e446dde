// glTF: damaged files end in an error that names the place, whatever the damage.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>

#include "base/error.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

// A bit of everything.
GltfBuilder rich_file() {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})},
                           {"NORMAL", b.positions(std::vector<vec3>(4, vec3(0, 0, 1)))},
                           {"TEXCOORD_0", b.uvs({{0, 1}, {1, 1}, {1, 0}, {0, 0}})}};
  const int mesh = b.mesh(attributes, b.indices({0, 1, 2, 0, 2, 3}), {{"material", 0}});
  Image8 image(2, 2);
  image.rgba.assign(16, 128);
  b.add("images", {{"bufferView", b.view(encode_png(image))}, {"mimeType", "image/png"}});
  b.root["samplers"] = {{{"wrapS", 33071}}};
  b.add("textures", {{"source", 0}, {"sampler", 0}});
  b.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"alphaMode", "MASK"}}};
  b.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.2}}}}};
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
  b.node({{"mesh", mesh}, {"rotation", {0, 0, 0, 1}}, {"camera", 0}});
  b.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const json instancing = {{"attributes", {{"TRANSLATION", b.positions({{0, 0, 0}, {5, 0, 0}})}}}};
  b.node({{"mesh", mesh}, {"extensions", {{"EXT_mesh_gpu_instancing", instancing}}}});
  return b;
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GltfMalformed, EveryErrorNamesItsPlaceAndWhatIsValid) {
  ASSERT_EQ(rich_file().load().objects.size(), 3u);
  struct Case {
    const char* pointer;  // what is replaced
    json value;
    std::string place;
  };
  const std::vector<Case> cases = {
      {"/asset", 5, "asset"},
      {"/asset/version", "1.0", "asset.version"},
      {"/asset/version", 2.0, "asset.version"},
      {"/asset/minVersion", "2.1", "asset.minVersion"},
      {"/asset", json::object(), "asset.version"},
      {"/scene", "0", "scene"},
      {"/scene", 1, "scene"},
      {"/scene", -1, "scene"},
      {"/scenes", json::object(), "scenes"},
      {"/scenes/0", 1, "scenes[0]"},
      {"/scenes/0/nodes/0", 99, "scenes[0].nodes[0]"},
      {"/scenes/0/nodes", "all", "scenes[0].nodes"},
      {"/nodes", 3, "nodes"},
      {"/nodes/0/mesh", 7, "nodes[0].mesh"},
      {"/nodes/0/camera", 1.5, "nodes[0].camera"},
      {"/nodes/0/children", {0}, "nodes[0].children"},
      {"/nodes/0/children", {1, 1}, "nodes[0].children[1]"},
      {"/nodes/0/rotation", {0, 0, 0}, "nodes[0].rotation"},
      {"/nodes/0/rotation", {0, 0, 0, 0}, "nodes[0].rotation"},
      {"/nodes/0/translation", {0, "x", 0}, "nodes[0].translation[1]"},
      {"/nodes/0/translation", {0, 1e39, 0}, "nodes[0].translation[1]"},
      {"/nodes/0/matrix", {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "nodes[0].matrix"},
      {"/nodes/1/extensions/KHR_lights_punctual/light", 1, "nodes[1].extensions.KHR_lights_punctual.light"},
      {"/nodes/2/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION", 99,
       "nodes[2].extensions.EXT_mesh_gpu_instancing.attributes.TRANSLATION"},
      {"/nodes/2/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION", 2,
       "nodes[2].extensions.EXT_mesh_gpu_instancing.attributes.TRANSLATION"},
      {"/nodes/2/extensions/EXT_mesh_gpu_instancing/attributes/SCALE", 0,
       "nodes[2].extensions.EXT_mesh_gpu_instancing.attributes"},
      {"/meshes/0/primitives/0/attributes/POSITION", 99, "meshes[0].primitives[0].attributes.POSITION"},
      {"/meshes/0/primitives/0/attributes/POSITION", 2, "meshes[0].primitives[0].attributes.POSITION"},
      {"/meshes/0/primitives/0/attributes/NORMAL", 4, "meshes[0].primitives[0].attributes.NORMAL"},
      {"/meshes/0/primitives/0/indices", 0, "meshes[0].primitives[0].indices"},
      {"/meshes/0/primitives/0/indices", -1, "meshes[0].primitives[0].indices"},
      {"/meshes/0/primitives/0/material", 1, "meshes[0].primitives[0].material"},
      {"/meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode"},
      {"/meshes/0/primitives/0/attributes", json::array(), "meshes[0].primitives[0].attributes"},
      {"/accessors/0/bufferView", 99, "accessors[0].bufferView"},
      {"/accessors/0/bufferView", nullptr, "accessors[0].bufferView"},
      {"/accessors/0/componentType", 5124, "accessors[0].componentType"},
      {"/accessors/0/componentType", 5130, "accessors[0].componentType"},
      {"/accessors/0/count", 0, "accessors[0].count"},
      {"/accessors/0/count", 5, "accessors[0].count"},
      {"/accessors/0/count", 4294967295u, "accessors[0].count"},
      {"/accessors/0/count", 18446744073709551615u, "accessors[0].count"},
      {"/accessors/0/count", -3, "accessors[0].count"},
      {"/accessors/0/type", "VEC5", "accessors[0].type"},
      {"/accessors/0/type", "MAT4", "accessors[0].count"},
      {"/accessors/0/byteOffset", 4, "accessors[0].count"},
      {"/accessors/0/byteOffset", 18446744073709551612u, "accessors[0].byteOffset"},
      {"/accessors/0/sparse", {{"count", 9}}, "accessors[0].sparse.count"},
      {"/accessors/0/sparse", {{"count", 1}}, "accessors[0].sparse.indices"},
      {"/bufferViews/0/buffer", 1, "bufferViews[0].buffer"},
      {"/bufferViews/0/byteLength", 18446744073709551615u, "bufferViews[0].byteLength"},
      {"/bufferViews/0/byteOffset", 1000000, "bufferViews[0].byteOffset"},
      {"/bufferViews/0/byteStride", 2, "bufferViews[0].byteStride"},
      {"/bufferViews/0/byteStride", 4, "accessors[0].bufferView"},
      {"/bufferViews/0/byteStride", 252, "accessors[0].count"},
      {"/buffers/0/byteLength", 100000, "buffers[0].byteLength"},
      {"/buffers/0/byteLength", 0, "buffers[0].byteLength"},
      {"/buffers/0/uri", "data:;;base64,AAAA", "buffers[0].uri"},
      {"/buffers/0/uri", "data:application/octet-stream;base64,A!AA", "buffers[0].uri"},
      {"/buffers/0/uri", "absent.bin", "buffers[0].uri"},
      {"/buffers/0/uri", 5, "buffers[0].uri"},
      {"/images/0/bufferView", 99, "images[0].bufferView"},
      {"/images/0/uri", "both.png", "images[0]"},
      {"/textures/0/source", -1, "textures[0].source"},
      {"/textures/0/sampler", 1, "textures[0].sampler"},
      {"/samplers/0/wrapS", 5, "samplers[0].wrapS"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 4,
       "materials[0].pbrMetallicRoughness.baseColorTexture.index"},
      {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1}, "materials[0].pbrMetallicRoughness.baseColorFactor"},
      {"/materials/0/pbrMetallicRoughness", 1, "materials[0].pbrMetallicRoughness"},
      {"/materials/0/alphaMode", "HALF", "materials[0].alphaMode"},
      {"/materials/0/alphaCutoff", "0.5", "materials[0].alphaCutoff"},
      {"/materials/0/doubleSided", 1, "materials[0].doubleSided"},
      {"/cameras/0/type", "fisheye", "cameras[0].type"},
      {"/cameras/0/perspective/yfov", 4, "cameras[0].perspective.yfov"},
      {"/cameras/0/perspective/znear", 0, "cameras[0].perspective.znear"},
      {"/cameras/0/perspective/zfar", 0.1, "cameras[0].perspective.zfar"},
      {"/extensions/KHR_lights_punctual/lights/0/type", "area", "extensions.KHR_lights_punctual.lights[0].type"},
      {"/extensions/KHR_lights_punctual/lights/0/intensity", -1, "extensions.KHR_lights_punctual.lights[0].intensity"},
      {"/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle", 0.6,
       "extensions.KHR_lights_punctual.lights[0].spot.innerConeAngle"},
      {"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", 3,
       "extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle"},
  };
  for (const Case& c : cases) {
    json document = json::parse(rich_file().gltf());
    document[json::json_pointer(c.pointer)] = c.value;
    const std::string message = error_of([&] { GltfBuilder::load_text(document.dump()); });
    EXPECT_TRUE(message.starts_with("test.gltf: " + c.place + ": ")) << c.pointer << " = " << c.value << " -> " << message;
    EXPECT_LT(message.size(), 400u) << message;
  }
}

TEST(GltfMalformed, RequiredExtensionsAreNamedWithTheSupportedOnes) {
  for (const std::string extension : {"EXT_mesh_made_up", "KHR_gaussian_splatting", "VENDOR_made_up", "nonsense"}) {
    GltfBuilder b = rich_file();
    b.root["extensionsRequired"] = {"KHR_mesh_quantization", extension};
    const std::string message = error_of([&] { b.load(); });
    EXPECT_TRUE(message.starts_with("test.gltf: extensionsRequired: " + extension)) << message;
    EXPECT_NE(message.find("KHR_draco_mesh_compression"), std::string::npos) << message;
    b.root.erase("extensionsRequired");
    b.root["extensionsUsed"] = {extension};
    EXPECT_NO_THROW(b.load()) << "used is not required";
  }
}

TEST(GltfMalformed, NumbersInBuffersMustBeFinite) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {inf, -inf, nan}) {
    GltfBuilder b;
    b.node({{"mesh", b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}})}})}});
    const std::string message = error_of([&] { b.load(); });
    EXPECT_TRUE(message.starts_with("test.gltf: accessors[0]: element 2 ")) << message;
  }
}

TEST(GltfMalformed, TransformsThatOverflowAreRefused) {
  GltfBuilder b;
  b.triangle();
  b.root["nodes"][0]["scale"] = {1e30, 1, 1};
  b.root["nodes"].push_back({{"children", {0}}, {"scale", {1e30, 1, 1}}});
  b.root["scenes"][0]["nodes"] = {1};
  EXPECT_TRUE(error_of([&] { b.load(); }).starts_with("test.gltf: objects[0].world_from_object: "))
      << error_of([&] { b.load(); });
}

TEST(GltfMalformed, SmallFilesCannotAskForGigabytes) {
  // Accessors without data are zeros, as many as they say.
  GltfBuilder zeros;
  zeros.add("accessors", {{"type", "VEC3"}, {"componentType", 5126}, {"count", 4000000000u}});
  zeros.node({{"mesh", zeros.mesh({{"POSITION", 0}})}});
  EXPECT_NE(error_of([&] { zeros.load(); }).find("far more than a file of this size"), std::string::npos);

  // A thousand primitives over one accessor of a million zeros.
  GltfBuilder many;
  many.add("accessors", {{"type", "VEC3"}, {"componentType", 5126}, {"count", 1000000}});
  for (int i = 0; i < 1000; ++i) many.node({{"mesh", many.mesh({{"POSITION", 0}})}});
  EXPECT_NE(error_of([&] { many.load(); }).find("far more than a file of this size"), std::string::npos);

  // A thousand nodes with a hundred thousand instances each.
  GltfBuilder bomb;
  bomb.triangle();
  const int scale = bomb.add("accessors", {{"type", "VEC3"}, {"componentType", 5126}, {"count", 100000}});
  for (int i = 0; i < 1000; ++i)
    bomb.node({{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", scale}}}}}}}});
  const std::string message = error_of([&] { bomb.load(); });
  EXPECT_TRUE(message.find("objects in the scene") != message.npos || message.find("far more than") != message.npos) << message;
}

TEST(GltfMalformed, CyclesAndSharedChildrenAreRefused) {
  GltfBuilder b;
  b.root["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
  b.root["scenes"] = {{{"nodes", {0}}}};
  EXPECT_TRUE(error_of([&] { b.load(); }).starts_with("test.gltf: nodes[2].children[0]: node 1 already has the parent 0"));
  b.root["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  EXPECT_TRUE(error_of([&] { b.load(); }).starts_with("test.gltf: nodes[0].children: the node is its own ancestor"));
  b.root["nodes"] = {{{"children", {1}}}, json::object()};
  b.root["scenes"] = {{{"nodes", {0, 1}}}};
  EXPECT_TRUE(error_of([&] { b.load(); }).starts_with("test.gltf: scenes[0].nodes[1]: "));
}

TEST(GltfMalformed, ContainerErrors) {
  const auto error_with = [](const std::function<void(std::vector<std::byte>&)>& damage) {
    std::vector<std::byte> bytes = rich_file().glb();
    damage(bytes);
    return error_of([&] { load_gltf_from_memory(bytes, "x.glb", {}); });
  };
  EXPECT_TRUE(error_with([](auto& b) { b[4] = std::byte{1}; }).starts_with("x.glb: header.version: "));
  EXPECT_TRUE(error_with([](auto& b) { b[8] ^= std::byte{1}; }).starts_with("x.glb: header.length: "));
  EXPECT_TRUE(error_with([](auto& b) { b[14] = std::byte{0xff}; }).starts_with("x.glb: chunks[0].length: "));
  EXPECT_TRUE(error_with([](auto& b) { b[16] = std::byte{0}; }).starts_with("x.glb: chunks[0].type: "));
  EXPECT_TRUE(error_with([](auto& b) { b[0] = std::byte{'G'}; }).starts_with("x.glb:1: byte 0: "));
  EXPECT_TRUE(error_with([](auto& b) { b.clear(); }).starts_with("x.glb:1: byte 0: "));
  EXPECT_TRUE(error_with([](auto& b) { b[20] = std::byte{'['}; }).starts_with("x.glb:1: byte "));
  EXPECT_TRUE(error_of([] { GltfBuilder::load_text("{\n  \"asset\": {]\n}"); }).starts_with("test.gltf:2: byte 14: "));
  EXPECT_TRUE(error_of([] { GltfBuilder::load_text("[]"); }).starts_with("test.gltf: top level: "));
  EXPECT_TRUE(error_of([] { GltfBuilder::load_text("{}"); }).starts_with("test.gltf: asset: is missing"));
  EXPECT_TRUE(error_of([] { GltfBuilder::load_text("{\"asset\": 1e999}"); }).starts_with("test.gltf: JSON: "));
  const std::string deep(1000000, '[');
  EXPECT_TRUE(error_of([&] { GltfBuilder::load_text(deep); }).starts_with("test.gltf:1: byte "));
  EXPECT_TRUE(error_of([&] {
                GltfBuilder::load_text("{\"asset\":{\"version\":\"2.0\"},\"scenes\":" + deep + std::string(1000000, ']') + "}");
              }).starts_with("test.gltf: scenes[0]: "));
}

// A file of any bytes either loads into a scene that holds its invariants or ends in an error that starts with its name.
void expect_loads_or_fails(const std::vector<std::byte>& bytes, const std::string& what) {
  try {
    check_scene(load_gltf_from_memory(bytes, "x.glb", {}));
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("x.glb:")) << what << ": " << error.what();
  }
}

TEST(GltfMalformed, EveryTruncationFails) {
  const std::vector<std::byte> bytes = rich_file().glb();
  for (size_t length = 0; length < bytes.size(); ++length) {
    const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(length));
    const std::string message = error_of([&] { load_gltf_from_memory(cut, "x.glb", {}); });
    ASSERT_TRUE(message.starts_with("x.glb:")) << "cut at " << length << ": " << message;
    // The same with a header that does not give it away.
    if (length < 20) continue;
    std::vector<std::byte> disguised = cut;
    const auto size = static_cast<uint32_t>(length);
    std::memcpy(&disguised[8], &size, 4);
    expect_loads_or_fails(disguised, fmt::format("disguised cut at {}", length));
  }
}

TEST(GltfMalformed, EveryFlippedByteLoadsOrFails) {
  const std::vector<std::byte> bytes = rich_file().glb();
  std::mt19937 random(11);
  for (size_t i = 0; i < bytes.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      std::vector<std::byte> damaged = bytes;
      damaged[i] = static_cast<std::byte>(random());
      if (k == 3) damaged[random() % bytes.size()] = static_cast<std::byte>(random());
      expect_loads_or_fails(damaged, fmt::format("byte {} = {}", i, static_cast<int>(damaged[i])));
    }
  }
}

// Replaces, removes or duplicates random members anywhere in the document.
void mutate(json& value, std::mt19937& random, int& budget) {
  static const std::vector<json> k_odd = {-1,
                                          0,
                                          1,
                                          3,
                                          255,
                                          65536,
                                          4294967295u,
                                          18446744073709551615u,
                                          1.5,
                                          -0.5,
                                          1e300,
                                          "",
                                          "VEC3",
                                          nullptr,
                                          true,
                                          json::array(),
                                          json::object(),
                                          json::array({0}),
                                          json::array({1, 2, 3}),
                                          json{{"index", 0}}};
  if (budget <= 0) return;
  if (value.is_structured() && !value.empty() && random() % 8 != 0) {
    auto item = value.begin();
    std::advance(item, random() % value.size());
    mutate(*item, random, budget);
    return;
  }
  value = k_odd[random() % k_odd.size()];
  --budget;
}

TEST(GltfMalformed, MutatedDocumentsLoadOrFail) {
  const json original = json::parse(rich_file().gltf());
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    json document = original;
    int budget = 1 + static_cast<int>(random() % 3);
    while (budget > 0) mutate(document, random, budget);
    const std::string text = document.dump();
    const auto bytes = std::as_bytes(std::span(text));
    expect_loads_or_fails({bytes.begin(), bytes.end()}, text);
  }
}

}  // namespace
}  // namespace gnomon
