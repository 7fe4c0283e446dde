// Blended materials: what of them casts, by the file's format and by scene.blend_casts; and as the CPU reference traces it.
#include "scene/blended.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"
#include "scene/casting.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using namespace scene_file_params;
using test_files::GltfBuilder;
using test_files::json;

SceneFileOptions with_rule(uint32_t rule) {
  SceneFileOptions options;
  options.params.blend_casts = rule;
  return options;
}

// A horizontal pane at height 1, from -1 to 1, of a blended material. Texture: its left half has that alpha, its right is
// clear.
Scene pane(double alpha, std::optional<uint8_t> left_alpha, uint32_t rule) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{-1, 1, -1}, {-1, 1, 1}, {1, 1, -1}, {1, 1, 1}})},
                           {"TEXCOORD_0", b.uvs({{0, 0}, {0, 1}, {1, 0}, {1, 1}})}};
  const int indices = b.indices({0, 1, 2, 2, 1, 3});
  json material = {{"name", "glass"},
                   {"alphaMode", "BLEND"},
                   {"doubleSided", true},
                   {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}};
  if (left_alpha) {
    Image8 image(16, 1);
    for (int x = 0; x < 16; ++x) image.at(x, 0)[3] = x < 8 ? *left_alpha : 0;
    b.add("textures", {{"source", b.add("images", {{"bufferView", b.view(encode_png(image))}, {"mimeType", "image/png"}})}});
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  }
  b.root["materials"] = json::array({material});
  b.node({{"mesh", b.mesh(attributes, indices, {{"material", 0}})}});
  const std::string text = b.gltf();
  return load_gltf_from_memory(std::as_bytes(std::span(text)), "test.gltf", {}, with_rule(rule));
}

struct Shadows {
  bool left, right;
  bool operator==(const Shadows&) const = default;
};

// Under a sun at the zenith. Something far below always casts: a reference without casters is refused.
Shadows shadows(Scene scene) {
  scene.materials.emplace_back();
  MeshPart below = test::floor_quad(1.0f, -9.0f);
  below.material = static_cast<int>(scene.materials.size()) - 1;
  test::add(scene, below);
  const std::vector<SurfacePoint> points = {test::floor_point(-0.5f, 0), test::floor_point(0.5f, 0)};
  const auto visibility = EmbreeReference(scene).trace(points, {0, 10, 0}, test::sun({0, -1, 0}), false, 1, 0).visibility;
  return {visibility[0] == 0.0f, visibility[1] == 0.0f};
}

TEST(Blended, OfOneAlphaCastsFromHalfItsOpacity) {
  EXPECT_EQ(shadows(pane(0.2, {}, blend_casts_mask)), (Shadows{false, false}));
  EXPECT_EQ(shadows(pane(0.9, {}, blend_casts_mask)), (Shadows{true, true}));
  EXPECT_EQ(shadows(pane(0.5, {}, blend_casts_mask)), (Shadows{true, true}));
  EXPECT_EQ(shadows(pane(0.2, {}, blend_casts_opaque)), (Shadows{true, true}));
  EXPECT_EQ(shadows(pane(0.9, {}, blend_casts_none)), (Shadows{false, false}));
}

TEST(Blended, ATextureCastsWhereItsAlphaTimesTheMaterialsIsHalf) {
  EXPECT_EQ(shadows(pane(1.0, 255, blend_casts_mask)), (Shadows{true, false}));
  EXPECT_EQ(shadows(pane(0.8, 200, blend_casts_mask)), (Shadows{true, false})) << "0.63";
  EXPECT_EQ(shadows(pane(0.6, 200, blend_casts_mask)), (Shadows{false, false})) << "0.47";
  EXPECT_EQ(shadows(pane(0.2, 255, blend_casts_mask)), (Shadows{false, false}));
  EXPECT_EQ(shadows(pane(0.2, 200, blend_casts_opaque)), (Shadows{true, false})) << "as the camera sees it";
  EXPECT_EQ(shadows(pane(0.0, 200, blend_casts_opaque)), (Shadows{true, false}));
  EXPECT_EQ(shadows(pane(1.0, 40, blend_casts_opaque)), (Shadows{true, false})) << "faint is not clear";
  EXPECT_EQ(shadows(pane(1.0, 40, blend_casts_mask)), (Shadows{false, false}));
  EXPECT_EQ(shadows(pane(1.0, 255, blend_casts_none)), (Shadows{false, false}));
}

// Receivers on glass stay: to the camera it is what it is with `opaque`.
TEST(Blended, TheCameraSeesTheSameUnderEveryRule) {
  for (const double alpha : {0.2, 1.0}) {
    for (const uint32_t rule : {blend_casts_opaque, blend_casts_mask, blend_casts_none}) {
      const Material m = pane(alpha, 200, rule).materials[0];
      EXPECT_TRUE(m.masked);
      EXPECT_NEAR(m.seen_cutoff() / m.base_colour.w, 0.5f, 1e-6f) << alpha << " " << rule;
      EXPECT_LT(pane(alpha, {}, rule).materials[0].seen_cutoff(), 0.0f);
    }
  }
}

TEST(Blended, WhatIsFaintIsSeenAndWhatIsClearIsNot) {
  for (const uint32_t rule : {blend_casts_opaque, blend_casts_mask, blend_casts_none}) {
    for (const int alpha : {2, 60, 255}) {
      const Scene scene = pane(1.0, static_cast<uint8_t>(alpha), rule);
      const Material& m = scene.materials[0];
      const Image8& seen = scene.textures.at(static_cast<size_t>(m.base_colour_texture)).image;
      EXPECT_GE(m.base_colour.w * static_cast<float>(seen.at(0, 0)[3]) / 255.0f, m.seen_cutoff()) << alpha;
      EXPECT_LT(m.base_colour.w * static_cast<float>(seen.at(12, 0)[3]) / 255.0f, m.seen_cutoff()) << alpha;
    }
  }
}

TEST(Blended, WhatIsNamedCastsAsTheCameraSeesIt) {
  const std::vector<std::string> on = {"glass=on"};
  for (const int alpha : {40, 140}) {
    Scene scene = pane(0.9, static_cast<uint8_t>(alpha), blend_casts_mask);
    apply_casting(scene, on);
    EXPECT_EQ(shadows(scene), (Shadows{true, false})) << alpha;
  }
  Scene plain = pane(0.2, {}, blend_casts_mask);
  apply_casting(plain, on);
  EXPECT_EQ(shadows(plain), (Shadows{true, true}));
}

// A pane without a picture whose vertices have those colours.
Scene pane_of_vertices(const std::string& mode, const std::vector<vec4>& colours) {
  GltfBuilder b;
  const json attributes = {{"POSITION", b.positions({{-1, 1, -1}, {-1, 1, 1}, {1, 1, -1}, {1, 1, 1}})},
                           {"COLOR_0", b.vec4s(colours)}};
  const int indices = b.indices({0, 1, 2, 2, 1, 3});
  b.root["materials"] = json::array({{{"name", "glass"}, {"alphaMode", mode}}, {{"name", "other"}}});
  b.node({{"mesh", b.mesh(attributes, indices, {{"material", 0}})}});
  return b.load();
}

TEST(Blended, AlphaOfVerticesCountsWhereItIsTheSameAllOver) {
  const vec4 faint(1, 1, 1, 0.25f), solid(1);
  EXPECT_EQ(shadows(pane_of_vertices("BLEND", {faint, faint, faint, faint})), (Shadows{false, false}));
  EXPECT_EQ(shadows(pane_of_vertices("MASK", {faint, faint, faint, faint})), (Shadows{false, false}));
  EXPECT_EQ(shadows(pane_of_vertices("OPAQUE", {faint, faint, faint, faint})), (Shadows{true, true}));
  const WarningWatch watch;
  EXPECT_EQ(shadows(pane_of_vertices("MASK", {faint, solid, faint, solid})), (Shadows{true, true}));
  ASSERT_EQ(watch.texts().size(), 1u);
  EXPECT_NE(watch.texts()[0].find("COLOR_0"), std::string::npos);
  EXPECT_NE(watch.texts()[0].find("glass (in meshes[0])"), std::string::npos) << watch.texts()[0];
}

TEST(Blended, DissolveOfMtlIsBlended) {
  const test_files::Folder folder;
  write_file(folder.path() / "a.mtl", std::string_view("newmtl glass\nKd 1 1 1\nd 0.2\nnewmtl smoke\nKd 1 1 1\nTr 0.3\n"));
  const auto load = [&](const std::string& material, uint32_t rule) {
    return load_obj_from_memory("mtllib a.mtl\nv -1 1 -1\nv -1 1 1\nv 1 1 1\nv 1 1 -1\nusemtl " + material + "\nf 1 2 3 4\n",
                                "a.obj", folder.path(), with_rule(rule));
  };
  EXPECT_EQ(shadows(load("glass", blend_casts_mask)), (Shadows{false, false}));
  EXPECT_EQ(shadows(load("smoke", blend_casts_mask)), (Shadows{true, true}));
  EXPECT_EQ(shadows(load("glass", blend_casts_opaque)), (Shadows{true, true}));
  EXPECT_EQ(shadows(load("smoke", blend_casts_none)), (Shadows{false, false}));
}

TEST(Blended, OneWarningNamesTheMaterials) {
  const WarningWatch watch;
  pane(0.2, {}, blend_casts_mask);
  ASSERT_EQ(watch.texts().size(), 1u);
  EXPECT_NE(watch.texts()[0].find("glass"), std::string::npos) << watch.texts()[0];
  EXPECT_NE(watch.texts()[0].find("scene.blend_casts"), std::string::npos) << watch.texts()[0];
  pane(1.0, {}, blend_casts_mask);
  EXPECT_EQ(watch.texts().size(), 1u) << "nothing shines through it";
}

}  // namespace
}  // namespace gnomon
