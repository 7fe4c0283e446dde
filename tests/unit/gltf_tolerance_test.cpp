// glTF: what is damaged, missing or unknown and does not touch the shadow is no reason to refuse a file; it is said.
#include <gtest/gtest.h>
#include <webp/encode.h>

#include "base/file.h"
#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

// The left column is a hole.
Image8 leaf() {
  Image8 image(4, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) image.at(x, y)[0] = static_cast<uint8_t>(60 * x), image.at(x, y)[3] = x == 0 ? 0 : 255;
  }
  return image;
}

std::vector<std::byte> webp(const Image8& image) {
  uint8_t* encoded = nullptr;
  const size_t size = WebPEncodeLosslessRGBA(image.rgba.data(), image.width, image.height, 4 * image.width, &encoded);
  const auto bytes = std::as_bytes(std::span(encoded, size));
  std::vector<std::byte> result(bytes.begin(), bytes.end());
  WebPFree(encoded);
  return result;
}

// A triangle of the alpha-tested material "leaf" with one texture.
GltfBuilder with_texture(const json& texture) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                           {"TEXCOORD_0", b.uvs({{0, 0}, {1, 0}, {0, 1}})}};
  b.node({{"mesh", b.mesh(attributes, -1, {{"material", 0}})}});
  b.root["materials"] = {
      {{"name", "leaf"}, {"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  b.add("textures", texture);
  return b;
}

std::string only_warning(const WarningWatch& watch) {
  EXPECT_EQ(watch.texts().size(), 1u) << fmt::format("{}", fmt::join(watch.texts(), "\n"));
  return watch.texts().empty() ? "" : watch.texts().back();
}

// --- textures ---

TEST(GltfTolerance, WebpIsRead) {
  GltfBuilder b = with_texture({{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
  b.add("images", {{"bufferView", b.view(webp(leaf()))}, {"mimeType", "image/webp"}});
  b.root["extensionsRequired"] = {"EXT_texture_webp"};
  const Scene scene = b.load();
  EXPECT_TRUE(scene.materials[0].masked);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].image.width, 4);
  EXPECT_EQ(scene.textures[0].image.at(0, 1)[3], 0);
  EXPECT_EQ(scene.textures[0].image.at(3, 1)[0], 180);
}

TEST(GltfTolerance, DamagedPicturesAreWarningsWithTheirPlace) {
  std::vector<std::byte> encoded = webp(leaf());
  const auto error_of = [](const std::vector<std::byte>& bytes) {
    GltfBuilder b = with_texture({{"source", 0}});
    b.add("images", {{"bufferView", b.view(bytes)}});
    const WarningWatch watch;
    const Scene scene = b.load();
    EXPECT_EQ(scene.triangle_count(), 1u);
    if (watch.texts().empty()) return std::string("no error");
    EXPECT_EQ(watch.texts().size(), 2u);
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_FALSE(scene.materials[0].masked);
    EXPECT_NE(watch.texts()[1].find("leaf; their cut-outs are lost"), std::string::npos) << watch.texts()[1];
    return watch.texts()[0];
  };
  EXPECT_EQ(error_of(encoded), "no error");
  EXPECT_TRUE(error_of({std::byte{'<'}, std::byte{'h'}}).starts_with("test.gltf: images[0]: not a picture"));
  for (size_t length = 12; length < encoded.size() - 2; ++length) {
    const std::vector<std::byte> cut(encoded.begin(), encoded.begin() + static_cast<ptrdiff_t>(length));
    EXPECT_TRUE(error_of(cut).starts_with("test.gltf: images[0]: ")) << length << " " << error_of(cut);
  }
  for (size_t i = 21; i < 25; ++i) encoded[i] = std::byte{0xff};  // 16384 x 16384 in some sixty bytes
  EXPECT_TRUE(error_of(encoded).starts_with("test.gltf: images[0]: ")) << error_of(encoded);
}

TEST(GltfTolerance, PicturesThatAreNotReadNameTheCutOutsThatAreLost) {
  GltfBuilder b = with_texture({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  b.root["extensionsRequired"] = {"KHR_texture_basisu", "KHR_materials_transmission"};
  const WarningWatch watch;
  EXPECT_FALSE(b.load().materials[0].masked);
  ASSERT_EQ(watch.texts().size(), 3u);
  EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: extensionsRequired: KHR_texture_basisu, KHR_materials_transmission"));
  EXPECT_TRUE(watch.texts()[1].starts_with("test.gltf: textures[0]: has no picture in a format that is read"));
  EXPECT_NE(watch.texts()[2].find("leaf; their cut-outs are lost"), std::string::npos) << watch.texts()[2];
}

TEST(GltfTolerance, ExtensionsThatCannotChangeShapesMayBeRequired) {
  for (const char* name : {"KHR_materials_clearcoat", "ADOBE_materials_thin_transparency", "MSFT_texture_dds",
                           "KHR_xmp_json_ld", "EXT_lights_image_based", "EXT_structural_metadata"}) {
    GltfBuilder b;
    b.triangle();
    b.root["extensionsRequired"] = {name};
    const WarningWatch watch;
    EXPECT_EQ(b.load().triangle_count(), 1u);
    EXPECT_NE(only_warning(watch).find(name), std::string::npos);
  }
}

TEST(GltfTolerance, TexturesThatNothingUsesMayBeDamaged) {
  const std::vector<json> damages = {{{"source", 9}}, {{"source", -1}}, {{"sampler", 4}}, {{"source", 1}}, {{"source", 0}}};
  for (const json& damage : damages) {
    GltfBuilder b = with_texture(damage);
    b.root["images"] = {{{"uri", "data:image/png;base64,AAAA"}}, json::object()};
    const bool is_picture = damage == json({{"source", 0}});
    EXPECT_EQ(b.error() == "no error", is_picture) << damage << ": it is used; a picture is a warning";
    b.root["meshes"][0]["primitives"][0].erase("material");
    const WarningWatch watch;
    EXPECT_EQ(b.error(), "no error") << damage;
    EXPECT_TRUE(watch.texts().empty()) << fmt::format("{}", fmt::join(watch.texts(), "\n"));
    EXPECT_TRUE(b.load().textures.empty());
  }
}

// --- buffers ---

TEST(GltfTolerance, BuffersThatNothingReadsMayBeDamaged) {
  const std::vector<json> damages = {{{"byteLength", 960}},
                                     {{"byteLength", 960}, {"uri", "absent.bin"}},
                                     {{"byteLength", 960}, {"uri", "data:application/octet-stream;base64,AAAA"}},
                                     {{"byteLength", 0}}};
  for (const json& damage : damages) {
    GltfBuilder b;
    b.triangle();
    b.root["buffers"][1] = damage;
    EXPECT_EQ(b.error(), "no error") << damage;
    b.root["bufferViews"][0]["buffer"] = 1;
    EXPECT_TRUE(b.error().starts_with("test.gltf: buffers[1].")) << b.error();
  }
  GltfBuilder malformed;
  malformed.triangle();
  malformed.root["buffers"][1] = {{"byteLength", 960}, {"uri", "data:;;base64,AAAA"}};
  EXPECT_TRUE(malformed.error().starts_with("test.gltf: buffers[1].uri: is a malformed data URI")) << malformed.error();
}

TEST(GltfTolerance, PicturesMayBeEmptyOrWithoutTheirBuffer) {
  for (const json& image : std::vector<json>{{{"uri", "data:image/png;base64,"}},
                                             {{"uri", "data:image/png;base64,%%%%"}},
                                             {{"bufferView", 0}, {"name", "bark"}}}) {
    GltfBuilder b = with_texture({{"source", 0}});
    b.root["images"] = json::array({image});
    if (image.contains("bufferView")) {
      b.root["buffers"][1] = {{"byteLength", 960}, {"uri", "absent.bin"}};
      b.root["images"][0]["bufferView"] = b.add("bufferViews", {{"buffer", 1}, {"byteLength", 960}});
    }
    const WarningWatch watch;
    EXPECT_EQ(b.error(), "no error") << image;
    ASSERT_EQ(watch.texts().size(), 2u) << image;
    EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: ")) << watch.texts()[0];
    EXPECT_NE(watch.texts()[0].find("keep their plain colour"), std::string::npos) << watch.texts()[0];
  }
}

TEST(GltfTolerance, MeshesThatNoNodeOfTheSceneShowsMayBeDamaged) {
  GltfBuilder b;
  b.triangle();
  b.root["buffers"][1] = {{"byteLength", 36}, {"uri", "absent.bin"}};
  const int view = b.add("bufferViews", {{"buffer", 1}, {"byteLength", 36}});
  const int positions =
      b.add("accessors", {{"bufferView", view}, {"componentType", test_files::k_float}, {"type", "VEC3"}, {"count", 3}});
  const int mesh = b.mesh({{"POSITION", positions}});
  EXPECT_EQ(b.error(), "no error") << "no node";
  const int node = b.add("nodes", {{"name", "hidden"}, {"mesh", mesh}});
  b.root["scenes"][1]["nodes"] = {node};
  EXPECT_EQ(b.error(), "no error") << "another scene";
  SceneFileOptions options;
  options.gltf_scene = "1";
  EXPECT_TRUE(b.error(options).starts_with("test.gltf: buffers[1].uri: absent.bin is not there")) << b.error(options);
  b.root["nodes"][0]["children"] = {node};
  b.root["scenes"].erase(1);
  EXPECT_TRUE(b.error().starts_with("test.gltf: buffers[1].uri: ")) << "a child";
  b.root["nodes"][static_cast<size_t>(node)]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
  EXPECT_EQ(b.error(), "no error") << "not visible";
}

TEST(GltfTolerance, TestedMaterialsWithoutCoordinatesHaveThePlainColour) {
  for (const int set : {0, 1}) {
    GltfBuilder b = with_texture({{"source", 0}});
    b.add("images", {{"bufferView", b.view(webp(leaf()))}});
    b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = set;
    if (set == 0) b.root["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
    const WarningWatch watch;
    const Scene scene = b.load();
    const Material& plain = scene.materials[static_cast<size_t>(scene.meshes[0].parts[0].material)];
    EXPECT_FALSE(plain.masked);
    EXPECT_EQ(plain.base_colour_texture, k_no_texture);
    EXPECT_NE(only_warning(watch).find("faces without texture coordinates: leaf (in meshes[0])"), std::string::npos);
  }
}

TEST(GltfTolerance, IndicesLeftOverAreSaid) {
  GltfBuilder b;
  const int positions = b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  b.node({{"mesh", b.mesh({{"POSITION", positions}}, b.indices({0, 1, 2, 2, 1}))}});
  const WarningWatch watch;
  EXPECT_EQ(b.load().triangle_count(), 1u);
  EXPECT_TRUE(only_warning(watch).starts_with("test.gltf: meshes[0].primitives[0].indices: 5 indices"));
}

TEST(GltfTolerance, Utf16IsNamed) {
  for (const std::string& text : {std::string("\xff\xfe{\0", 4), std::string("\xfe\xff\0{", 4)}) {
    try {
      GltfBuilder::load_text(text);
      FAIL();
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "test.gltf:1: UTF-16 text; valid: UTF-8");
    }
  }
}

TEST(GltfTolerance, LineBreaksInNamesAreText) {
  const test_files::Folder folder;
  GltfBuilder b;
  b.triangle();
  b.root["nodes"][0]["name"] = "a\nb";
  b.root["materials"] = json::array({{{"name", "in\ntwo"}, {"alphaMode", "MASK"}, {"alphaCutoff", 2}}});
  b.root["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string path = (folder.path() / "test.gltf").string();
  write_file(path, b.gltf());
  const WarningWatch watch;
  EXPECT_EQ(load_scene(path).objects.at(0).name, "a\\x0ab");
  EXPECT_NE(only_warning(watch).find("in\\x0atwo"), std::string::npos) << only_warning(watch);
  b.root["materials"][0]["alphaMode"] = "x\ny";
  write_file(path, b.gltf());
  try {
    load_scene(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

// --- numbers ---

TEST(GltfTolerance, NormalsAndTangentsWithoutMeaningAreRemade) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}})},
                           {"NORMAL", b.positions({{nan, 0, 0}, {0, 2, 0}, {0, 0, 0}})},
                           {"TANGENT", b.vec4s({{1, 0, 0, 1}, {1, inf, 0, 1}, {1, 0, 0, 1}})}};
  b.node({{"mesh", b.mesh(attributes)}});
  b.root["meshes"][0]["name"] = "roof";
  const WarningWatch watch;
  const Scene scene = b.load();
  for (const vec3& n : scene.meshes.at(0).parts.at(0).normals) EXPECT_EQ(n, vec3(0, 1, 0));
  ASSERT_EQ(watch.texts().size(), 2u);
  EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: meshes[0] ('roof'): 2 normals ")) << watch.texts()[0];
  EXPECT_TRUE(watch.texts()[1].starts_with("test.gltf: meshes[0] ('roof'): 1 tangents ")) << watch.texts()[1];
}

TEST(GltfTolerance, CoordinatesAndColoursToo) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}})},
                           {"TEXCOORD_0", b.uvs({{0, nan}, {1, 1}, {0, 1}})},
                           {"COLOR_0", b.vec4s({{1, 1, 1, nan}, {1, 1, 1, 1}, {1, 1, 1, 1}})}};
  b.node({{"mesh", b.mesh(attributes)}});
  const WarningWatch watch;
  EXPECT_EQ(b.load().triangle_count(), 1u);
  EXPECT_EQ(watch.texts().size(), 2u);
}

}  // namespace
}  // namespace gnomon
