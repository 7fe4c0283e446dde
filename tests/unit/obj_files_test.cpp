// OBJ files with what lies around them: libraries and pictures where exporters put them, alpha that may mean holes, and what
// is said of all that.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "base/warning_watch.h"
#include "scene/load.h"
#include "scene/obj/obj_libraries.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using Texel = std::array<uint8_t, 4>;
constexpr const char* k_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 0.5\n";

class ObjFiles : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    make_folder((folder_.path() / name).parent_path());
    write_file(folder_.path() / name, text);
  }
  void picture(const std::string& name, const std::function<Texel(int, int)>& colour, int size = 16) {
    make_folder((folder_.path() / name).parent_path());
    folder_.picture(name, size, size, colour);
  }
  void plain_picture(const std::string& name, uint8_t red) {
    picture(
        name,
        [&](int, int) {
          return Texel{red, 0, 0, 255};
        },
        1);
  }

  Scene load(const std::string& head, const std::string& faces = "usemtl m\nf 1/1 2/2 3/3\n",
             uint32_t alpha = scene_file_params::alpha_from_colour_auto) {
    SceneFileOptions options;
    options.params.alpha_from_colour = alpha;
    WarningWatch watch;
    Scene scene = load_obj_from_memory(head + "\n" + k_triangle + faces, "test.obj", folder_.path(), options);
    warnings_ = watch.texts();
    return scene;
  }
  Scene load_with(const std::string& mtl, uint32_t alpha = scene_file_params::alpha_from_colour_auto) {
    write("lib.mtl", mtl);
    return load("mtllib lib.mtl", "usemtl m\nf 1/1 2/2 3/3\n", alpha);
  }
  int red_of(const Scene& scene) {
    const int texture = scene.materials.at(0).base_colour_texture;
    return texture < 0 ? -1 : scene.textures.at(static_cast<size_t>(texture)).image.rgba[0];
  }
  // How many warnings hold the text.
  ptrdiff_t warned(const std::string& text) {
    return std::count_if(warnings_.begin(), warnings_.end(), [&](const auto& w) { return w.find(text) != w.npos; });
  }

  test_files::Folder folder_;
  std::vector<std::string> warnings_;
};

// --- where files lie ---

TEST_F(ObjFiles, PicturesAreNamedFromTheirLibraryElseFromTheScene) {
  plain_picture("lib/pic/red.png", 11);
  write("lib/box.mtl", "newmtl m\nmap_Kd pic/red.png\n");
  EXPECT_EQ(red_of(load("mtllib lib/box.mtl")), 11);
  plain_picture("pic/red.png", 22);
  EXPECT_EQ(red_of(load("mtllib lib/box.mtl")), 11);
  std::filesystem::remove(folder_.path() / "lib/pic/red.png");
  EXPECT_EQ(red_of(load("mtllib lib/box.mtl")), 22);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(ObjFiles, LettersOfAnotherCase) {
  plain_picture("Red.PNG", 33);
  write("A.MTL", "newmtl m\nmap_Kd rEd.png\n");
  EXPECT_EQ(red_of(load("mtllib a.mtl")), 33);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(ObjFiles, TwoLibrariesMayHavePicturesOfOneName) {
  plain_picture("a/x.png", 1), plain_picture("b/x.png", 2);
  write("a/a.mtl", "newmtl m\nmap_Kd x.png\n"), write("b/b.mtl", "newmtl n\nmap_Kd x.png\n");
  const Scene scene = load("mtllib a/a.mtl b/b.mtl", "usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 3/3 2/2 1/1\n");
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.textures[0].image.rgba[0], 1);
  EXPECT_EQ(scene.textures[1].image.rgba[0], 2);
}

TEST_F(ObjFiles, SeveralLibrariesWithBlanksInOneLine) {
  write("my red.mtl", "newmtl m\nKd 1 0 0\n"), write("my blue.mtl", "newmtl n\nKd 0 0 1\n");
  const std::string faces = "usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 3/3 2/2 1/1\n";
  for (const std::string line : {"mtllib my red.mtl my blue.mtl", "mtllib My Red.MTL My Blue.MTL",
                                 "mtllib my\\ red.mtl my\\ blue.mtl", "mtllib absent one.mtl my blue.mtl my red.mtl"}) {
    const Scene scene = load(line, faces);
    EXPECT_EQ(scene.materials.at(0).base_colour, vec4(1, 0, 0, 1)) << line;
    EXPECT_EQ(scene.materials.at(1).base_colour, vec4(0, 0, 1, 1)) << line;
  }
  EXPECT_EQ(warned("library absent one.mtl is not there"), 1);
}

TEST(ObjLibraryNames, AreSplitByWhatIsThere) {
  const auto split = [](const std::string& text, const std::vector<std::string>& files) {
    return split_library_names(
        text, [&](const std::string& name) { return std::find(files.begin(), files.end(), name) != files.end(); });
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(split("a b.mtl c", {"a", "b.mtl", "c"}), (Names{"a", "b.mtl", "c"}));
  EXPECT_EQ(split("a b.mtl c.mtl", {"a b.mtl"}), (Names{"a b.mtl", "c.mtl"}));
  EXPECT_EQ(split("x y.mtl a.mtl", {}), (Names{"x y.mtl", "a.mtl"}));
  EXPECT_EQ(split("no ending", {}), (Names{"no ending"}));
  EXPECT_EQ(split("", {}), Names{});
}

TEST_F(ObjFiles, WhatNothingUsesIsNotRead) {
  write("broken.png", "not a picture");
  write("lib.mtl", "newmtl unused\nmap_Kd broken.png\nnewmtl named\nmap_Kd absent.png\nnewmtl m\nKd 0 1 0\n");
  const Scene scene = load("mtllib lib.mtl", "usemtl named\nusemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_TRUE(warnings_.empty());
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].base_colour, vec4(0, 1, 0, 1));
}

// --- what is not there ---

TEST_F(ObjFiles, BumpMapsHoldNoHoles) {
  load_with("newmtl m\nKd 1 1 1\nbump absent.png\n");
  EXPECT_EQ(warned("missing bump and normal maps: absent.png; their materials look smoother; shadows are the same"), 1);
  EXPECT_EQ(warned("cut-outs"), 0);
  write("broken.png", "not a picture");
  load_with("newmtl m\nKd 1 1 1\nnorm broken.png\n");
  EXPECT_EQ(warned("broken.png: not a picture"), 1);
  EXPECT_EQ(warned("cut-outs"), 0);
  load_with("newmtl m\nmap_Kd absent.png\nbump absent.png\n");
  EXPECT_EQ(warned("missing textures: absent.png; "), 1);
  EXPECT_EQ(warned("cut-outs"), 1);
}

TEST_F(ObjFiles, FilesThatWereNotFetched) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
  write("a.png", pointer);
  EXPECT_EQ(load_with("newmtl m\nmap_Kd a.png\n").materials.size(), 1u);
  EXPECT_EQ(warned("a.png: is a Git LFS pointer"), 1);
  write("a.mtl", pointer);
  EXPECT_EQ(load("mtllib a.mtl").materials.at(0).base_colour, vec4(1.0f));
  EXPECT_EQ(warned("a.mtl: is a Git LFS pointer"), 1);
}

TEST_F(ObjFiles, AThousandLibrariesAreCounted) {
  std::string head;
  for (int i = 0; i < 1000; ++i) head += fmt::format("mtllib absent{}.mtl\n", i);
  write("scene.obj", head + k_triangle + "f 1 2 3\n");
  WarningWatch watch;
  load_scene((folder_.path() / "scene.obj").string());
  warnings_ = watch.texts();
  EXPECT_EQ(warned("the material library absent"), 6) << "five, and their number";
  EXPECT_EQ(warned("and 995 more like this one"), 1);
}

// --- alpha of colour pictures ---

Texel leaf(int x, int) { return {0, 200, 0, static_cast<uint8_t>(x < 5 ? 0 : 255)}; }
Texel gloss(int x, int y) { return {0, 200, 0, static_cast<uint8_t>(15 * x + 2 * y)}; }

TEST_F(ObjFiles, ABimodalAlphaCutsAndIsNamed) {
  picture("a.png", leaf);
  EXPECT_TRUE(load_with("newmtl m\nd 1\nmap_Kd a.png\n").materials[0].masked);
  EXPECT_EQ(warned("holes taken from the alpha of map_Kd"), 1);
  EXPECT_EQ(warned("m (31.2 %)"), 1) << "5 of 16 columns";
  EXPECT_EQ(warned("scene.alpha_from_colour=off"), 1);
}

TEST_F(ObjFiles, ASmoothAlphaDoesNotCutAndIsNamed) {
  picture("a.png", gloss);
  EXPECT_FALSE(load_with("newmtl m\nd 1\nmap_Kd a.png\n").materials[0].masked);
  EXPECT_EQ(warned("no holes taken from the alpha of map_Kd, which is smooth: m ("), 1);
  EXPECT_EQ(warned("scene.alpha_from_colour=on"), 1);
}

TEST_F(ObjFiles, AlphaThatCutsNothingIsNotSpokenOf) {
  picture("a.png", [](int, int y) { return Texel{0, 200, 0, static_cast<uint8_t>(160 + 5 * y)}; });
  EXPECT_FALSE(load_with("newmtl m\nmap_Kd a.png\n").materials[0].masked);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(ObjFiles, TheSettingDecidesInstead) {
  picture("leaf.png", leaf), picture("gloss.png", gloss);
  const std::string leaf_mtl = "newmtl m\nmap_Kd leaf.png\n", gloss_mtl = "newmtl m\nmap_Kd gloss.png\n";
  EXPECT_FALSE(load_with(leaf_mtl, scene_file_params::alpha_from_colour_off).materials[0].masked);
  EXPECT_TRUE(warnings_.empty());
  EXPECT_TRUE(load_with(leaf_mtl, scene_file_params::alpha_from_colour_on).materials[0].masked);
  EXPECT_TRUE(load_with(gloss_mtl, scene_file_params::alpha_from_colour_on).materials[0].masked);
  EXPECT_TRUE(warnings_.empty());
  // Where the file says it, there is nothing to decide.
  EXPECT_TRUE(load_with(gloss_mtl + "map_d gloss.png\n", scene_file_params::alpha_from_colour_off).materials[0].masked);
  EXPECT_TRUE(load_with(gloss_mtl + "map_d gloss.png\n").materials[0].masked);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(ObjFiles, AlphaThatWouldLeaveNothingIsNotCalledSmooth) {
  picture("a.png", [](int, int) { return Texel{0, 200, 0, 0}; });
  EXPECT_FALSE(load_with("newmtl m\nmap_Kd a.png\n").materials[0].masked);
  EXPECT_EQ(warned("nothing would be left of m"), 1);
  EXPECT_EQ(warned("smooth"), 0);
}

TEST_F(ObjFiles, DissolveIsMultipliedWithThePicture) {
  picture("a.png", leaf);
  for (const std::string map : {"map_Kd a.png\n", "map_d a.png\n"}) {
    const Material m = load_with("newmtl m\nd 0.4\n" + map).materials[0];
    EXPECT_TRUE(m.blended && m.masked);
    EXPECT_FALSE(m.casts) << "0.4 at most";
    EXPECT_EQ(warned("blended materials: m; "), 1);
    const Material solid = load_with("newmtl m\nTr 0.3\n" + map).materials[0];
    EXPECT_TRUE(solid.casts && solid.half_casts);
    EXPECT_FLOAT_EQ(solid.base_colour.w, 0.7f);
  }
}

TEST_F(ObjFiles, AMapOfTransparencyIsTheOpposite) {
  picture("a.png", [](int x, int) { return x < 4 ? Texel{255, 255, 255, 255} : Texel{0, 0, 0, 255}; });
  const auto alpha_at_left = [&](const std::string& keyword) {
    const Scene scene = load_with("newmtl m\n" + keyword + " a.png\n");
    EXPECT_TRUE(scene.materials[0].masked) << keyword;
    return scene.textures.at(0).image.at(0, 0)[3];
  };
  EXPECT_EQ(alpha_at_left("map_d"), 255);
  EXPECT_EQ(alpha_at_left("map_opacity"), 255);
  EXPECT_EQ(alpha_at_left("map_Tr"), 0);
}

TEST_F(ObjFiles, WhatIsCutAwayAsAWholeIsNamed) {
  picture("a.png", [](int, int) { return Texel{60, 60, 60, 255}; });
  load_with("newmtl m\nmap_d a.png\n");
  EXPECT_EQ(warned("cut away as a whole: m; "), 1);
}

TEST_F(ObjFiles, ACommentMayFollowAPicture) {
  picture("a.png", leaf), picture("b #2.png", leaf);
  EXPECT_EQ(load_with("newmtl m\nmap_Kd a.png # bark\n").textures.size(), 1u);
  EXPECT_EQ(warned("missing"), 0);
  EXPECT_EQ(load_with("newmtl m\nmap_Kd b #2.png\n").textures.size(), 1u);
  EXPECT_EQ(warned("missing"), 0);
}

// --- faces without texture coordinates ---

TEST_F(ObjFiles, FacesWithoutCoordinatesHaveThePlainColour) {
  picture("a.png", leaf);
  for (const std::string map : {"map_Kd a.png\n", "map_d a.png\n"}) {
    write("lib.mtl", "newmtl m\nKd 0 1 0\n" + map);
    const Scene bare = load("mtllib lib.mtl", "usemtl m\nf 1 2 3\n");
    const Material& plain = bare.materials[static_cast<size_t>(bare.meshes[0].parts[0].material)];
    EXPECT_EQ(plain.name, "m");
    EXPECT_EQ(plain.base_colour, vec4(0, 1, 0, 1));
    EXPECT_EQ(plain.base_colour_texture, k_no_texture);
    EXPECT_FALSE(plain.masked);
    EXPECT_EQ(warned("faces without texture coordinates: m (in test.obj); "), 1);
    EXPECT_EQ(warned("holes taken"), 0);
    const Scene both = load("mtllib lib.mtl", "o tree\nusemtl m\nf 1 2 3\nf 1/1 2/2 3/3\n");
    ASSERT_EQ(both.meshes[0].parts.size(), 2u);
    EXPECT_FALSE(both.materials[static_cast<size_t>(both.meshes[0].parts[0].material)].masked);
    EXPECT_TRUE(both.materials[static_cast<size_t>(both.meshes[0].parts[1].material)].masked);
    EXPECT_EQ(warned("m (in tree)"), 1);
  }
  write("lib.mtl", "newmtl m\nKd 0 1 0\n");
  load("mtllib lib.mtl", "usemtl m\nf 1 2 3\n");
  EXPECT_TRUE(warnings_.empty()) << "nothing is lost";
}

// --- what is left out of the geometry ---

TEST_F(ObjFiles, LinesPointsAndSurfacesAreSummedUp) {
  load("l 1 2\nl 2 3\np 1", "usemtl m\nf 1/1 2/2 3/3\ncstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3\nparm u 0 1\nend\ns off\n");
  EXPECT_EQ(warned("left out"), 1);
  EXPECT_EQ(warned("test.obj:1: "), 1);
  EXPECT_EQ(warned("2 lines (l), 1 points (p), 1 surfaces (surf)"), 1);
}

TEST_F(ObjFiles, IndicesThatPointAtNothingCostTheirAttributeOnly) {
  const Scene uvs = load("", "f 1/1 2/2 3/9\nf 1/1 2/-7 3/3\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(uvs.triangle_count(), 3u);
  EXPECT_EQ(warned("test.obj:8: 2 face(s) name texture coordinates (vt) that are not there"), 1);
  size_t at_origin = 0;
  for (const vec2& uv : uvs.meshes[0].parts[0].uvs) at_origin += uv == vec2(0.0f);
  EXPECT_EQ(at_origin, 3u) << "all corners of a face, or none";
  const Scene normals = load("vn 0 0 -1", "f 1//1 2//1 3//1\nf 1//1 2//0 3//1\nf 1/1/1 2/2/99999999999999999999 3/3/1\n");
  EXPECT_EQ(normals.triangle_count(), 3u);
  EXPECT_EQ(warned("test.obj:9: 2 face(s) name normals (vn) that are not there"), 1);
  ASSERT_EQ(normals.meshes[0].parts.size(), 3u) << "the last has texture coordinates, too";
  EXPECT_EQ(normals.meshes[0].parts[0].normals[0], vec3(0, 0, -1)) << "given";
  EXPECT_EQ(normals.meshes[0].parts[1].normals[0], vec3(0, 0, 1)) << "made";
  EXPECT_EQ(normals.meshes[0].parts[2].normals[0], vec3(0, 0, 1)) << "made";
}

TEST_F(ObjFiles, FacesByTheirOldName) { EXPECT_EQ(load("", "fo 1/1 2/2 3/3\n").triangle_count(), 1u); }

}  // namespace
}  // namespace gnomon
