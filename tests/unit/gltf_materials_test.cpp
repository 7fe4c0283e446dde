// glTF: materials, textures and pictures, from generated files.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

std::vector<std::byte> png(uint8_t red, bool with_holes, int size = 4) {
  Image8 image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      uint8_t* p = image.at(x, y);
      p[0] = red, p[3] = with_holes && x == 0 ? 0 : 255;
    }
  }
  return encode_png(image);
}

// A triangle with one material.
GltfBuilder with_material(const json& material) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                           {"TEXCOORD_0", b.uvs({{0, 0}, {0.5f, 0}, {0, 0.5f}})},
                           {"TEXCOORD_1", b.uvs({{1, 1}, {1, 0.75f}, {0.75f, 1}})}};
  b.node({{"mesh", b.mesh(attributes, -1, {{"material", 0}})}});
  b.root["materials"] = json::array({material});
  return b;
}

// Only textures of materials in use are read.
void add_material_in_use(GltfBuilder& b, const json& material) {
  b.node({{"mesh", b.mesh({{"POSITION", 0}}, -1, {{"material", b.add("materials", material)}})}});
}

int embed_picture(GltfBuilder& b, const std::vector<std::byte>& encoded, const json& texture = json::object()) {
  const int image = b.add("images", {{"bufferView", b.view(encoded)}, {"mimeType", "image/png"}});
  json t = texture;
  t["source"] = image;
  return b.add("textures", t);
}

const json k_textured = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};

TEST(GltfMaterials, FactorsAndDefaults) {
  GltfBuilder b =
      with_material({{"name", "paint"},
                     {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"roughnessFactor", 0.5}}},
                     {"emissiveFactor", {1, 0.5, 0}},
                     {"doubleSided", true},
                     {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
  b.node({{"mesh", b.mesh({{"POSITION", 0}})}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.materials.size(), 2u) << "and the default one of the second mesh";
  const Material& m = scene.materials[0];
  EXPECT_EQ(m.name, "paint");
  EXPECT_EQ(m.base_colour, vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.emissive, vec3(4, 2, 0));
  EXPECT_TRUE(m.double_sided);
  EXPECT_FALSE(m.masked);
  EXPECT_GT(m.shininess, 10.0f);
  EXPECT_EQ(scene.meshes[1].parts[0].material, 1);
  EXPECT_EQ(scene.materials[1].base_colour, vec4(1.0f));
}

TEST(GltfMaterials, MaskKeepsItsCutoff) {
  json material = k_textured;
  material["alphaMode"] = "MASK";
  material["alphaCutoff"] = 0.25;
  GltfBuilder b = with_material(material);
  embed_picture(b, png(1, true));
  const Scene scene = b.load();
  EXPECT_TRUE(scene.materials[0].masked);
  EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.25f);
  EXPECT_FALSE(scene.materials[0].double_sided);

  GltfBuilder solid = with_material(material);
  embed_picture(solid, png(1, false));
  EXPECT_FALSE(solid.load().materials[0].masked) << "nothing can fail the test: same picture, less work";
  material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.2};
  GltfBuilder invisible = with_material(material);
  embed_picture(invisible, png(1, false));
  EXPECT_TRUE(invisible.load().materials[0].masked) << "everything fails the test";
}

TEST(GltfMaterials, BlendIsMaskedWhereTheTextureHasHoles) {
  json material = k_textured;
  material["alphaMode"] = "BLEND";
  GltfBuilder b = with_material(material);
  embed_picture(b, png(1, true));
  const Scene scene = b.load();
  EXPECT_TRUE(scene.materials[0].masked);
  EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.5f);
  GltfBuilder solid = with_material(material);
  embed_picture(solid, png(1, false));
  EXPECT_FALSE(solid.load().materials[0].masked);
  GltfBuilder opaque = with_material(k_textured);
  embed_picture(opaque, png(1, true));
  EXPECT_FALSE(opaque.load().materials[0].masked) << "OPAQUE ignores alpha";
}

TEST(GltfMaterials, PicturesFromViewsUrisAndFiles) {
  test_files::Folder folder;
  write_file(folder.path() / "a picture.png", png(30, false));
  GltfBuilder b = with_material(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 1}, {"scale", 0.5}}}});
  embed_picture(b, png(10, false));
  b.add("images", {{"uri", GltfBuilder::data_uri(png(20, false), "image/png")}});
  b.add("textures", {{"source", 1}});
  b.add("images", {{"uri", "a%20picture.png"}});
  b.add("textures", {{"source", 2}});
  add_material_in_use(b, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 2}}}}}});
  const Scene scene = b.load(folder.path());
  ASSERT_EQ(scene.textures.size(), 3u);
  const auto red = [&](int texture) { return scene.textures.at(static_cast<size_t>(texture)).image.rgba.at(0); };
  EXPECT_EQ(red(scene.materials[0].base_colour_texture), 10);
  EXPECT_EQ(red(scene.materials[0].normal_texture), 20);
  EXPECT_EQ(red(scene.materials[1].base_colour_texture), 30);
  EXPECT_TRUE(scene.textures[static_cast<size_t>(scene.materials[0].base_colour_texture)].srgb);
  EXPECT_FALSE(scene.textures[static_cast<size_t>(scene.materials[0].normal_texture)].srgb);
  EXPECT_EQ(scene.materials[0].normal_scale, 0.5f);
}

TEST(GltfMaterials, WrapModesAndSharing) {
  GltfBuilder b = with_material(k_textured);
  embed_picture(b, png(1, false));
  b.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  b.add("textures", {{"source", 0}, {"sampler", 0}});
  b.add("textures", {{"source", 0}});
  add_material_in_use(b, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
  add_material_in_use(b, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 2}}}}}});
  const Scene scene = b.load();
  ASSERT_EQ(scene.textures.size(), 2u) << "one picture with two wrap modes";
  EXPECT_EQ(scene.textures[0].wrap_u, Wrap::repeat);
  EXPECT_EQ(scene.textures[1].wrap_u, Wrap::clamp);
  EXPECT_EQ(scene.textures[1].wrap_v, Wrap::mirror);
  EXPECT_EQ(scene.textures[1].image.rgba, scene.textures[0].image.rgba);
  EXPECT_EQ(scene.materials[2].base_colour_texture, scene.materials[0].base_colour_texture);
}

TEST(GltfMaterials, TextureTransformAndSecondUvSet) {
  json info = {{"index", 0}, {"texCoord", 1}};
  info["extensions"]["KHR_texture_transform"] = {{"offset", {0, 1}}, {"rotation", k_pi / 2}, {"scale", {0.5, 0.5}}};
  GltfBuilder b = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", info}}}});
  b.root["extensionsRequired"] = {"KHR_texture_transform"};
  embed_picture(b, png(1, false));
  const Scene scene = b.load();
  const vec2 uv = scene.materials[0].base_colour_uv.apply({1, 0});
  EXPECT_NEAR(uv.x, 0.0f, 1e-6f);
  EXPECT_NEAR(uv.y, 0.5f, 1e-6f);
  const MeshPart& part = scene.meshes[0].parts[0];
  for (const vec2& v : part.uvs) EXPECT_GE(v.x, 0.75f) << "TEXCOORD_1";
  info["extensions"]["KHR_texture_transform"]["texCoord"] = 0;
  b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = info;
  const Scene first_set = b.load();
  for (const vec2& v : first_set.meshes[0].parts[0].uvs) EXPECT_LE(v.x, 0.5f) << "the extension's texCoord wins";
}

TEST(GltfMaterials, SpecularGlossinessAndUnlit) {
  GltfBuilder b = with_material({{"extensions",
                                  {{"KHR_materials_pbrSpecularGlossiness",
                                    {{"diffuseFactor", {0.5, 0.25, 0.125, 1}},
                                     {"specularFactor", {0.3, 0.2, 0.1}},
                                     {"glossinessFactor", 0.5},
                                     {"diffuseTexture", {{"index", 0}}}}}}}});
  embed_picture(b, png(77, false));
  b.root["materials"].push_back({{"extensions", {{"KHR_materials_unlit", json::object()}}}});
  b.root["extensionsRequired"] = {"KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit"};
  const Scene scene = b.load();
  EXPECT_EQ(scene.materials[0].base_colour, vec4(0.5f, 0.25f, 0.125f, 1));
  EXPECT_EQ(scene.materials[0].specular, vec3(0.3f, 0.2f, 0.1f));
  EXPECT_EQ(scene.textures.at(static_cast<size_t>(scene.materials[0].base_colour_texture)).image.rgba[0], 77);
}

TEST(GltfMaterials, AMissingOrDamagedPictureKeepsTheColour) {
  GltfBuilder b =
      with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
  b.add("textures", {{"source", 0}});
  b.add("images", {{"uri", "absent.png"}});
  const Scene scene = b.load();
  EXPECT_EQ(scene.materials[0].base_colour_texture, k_no_texture);
  EXPECT_EQ(scene.materials[0].base_colour, vec4(0, 1, 0, 1));

  GltfBuilder damaged = with_material(k_textured);
  auto encoded = png(1, false, 64);
  encoded.resize(encoded.size() / 2);
  embed_picture(damaged, encoded);
  {
    const WarningWatch watch;
    EXPECT_EQ(damaged.load().materials[0].base_colour_texture, k_no_texture);
    ASSERT_EQ(watch.texts().size(), 1u);
    EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: images[0]: ")) << watch.texts()[0];
  }
  damaged.root["materials"] = json::array({json::object()});
  const WarningWatch watch;
  damaged.load();
  EXPECT_TRUE(watch.texts().empty()) << "pictures that nothing uses are not decoded";
}

TEST(GltfMaterials, APictureThatClaimsToBeHugeIsRefusedBeforeItCostsAnything) {
  GltfBuilder b = with_material(k_textured);
  auto encoded = png(1, false);
  encoded[18] = encoded[22] = std::byte{0x40},
  encoded[19] = encoded[23] = std::byte{0};  // 16384 x 16384 in the header of a file of less than 100 bytes
  embed_picture(b, encoded);
  const WarningWatch watch;
  b.load();
  ASSERT_FALSE(watch.texts().empty());
  EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: images[0]: ")) << watch.texts()[0];
  EXPECT_NE(watch.texts()[0].find("cannot be in"), std::string::npos) << watch.texts()[0];
}

TEST(GltfMaterials, AFormatThatIsNotReadFallsBack) {
  GltfBuilder b = with_material(k_textured);
  embed_picture(b, png(5, false), {{"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}});
  b.root["extensionsUsed"] = {"EXT_texture_webp"};
  EXPECT_EQ(b.load().textures.size(), 1u);
  GltfBuilder only = with_material(k_textured);
  only.add("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  EXPECT_EQ(only.load().materials[0].base_colour_texture, k_no_texture);
}

}  // namespace
}  // namespace gnomon
