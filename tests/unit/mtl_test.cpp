// MTL numbers and options as files have them; what is misread is said, with its line.
#include "scene/obj/mtl_text.h"

#include <gtest/gtest.h>

#include "base/warning_watch.h"

namespace gnomon {
namespace {

struct Read {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> warnings;
};

Read read(const std::string& statements) {
  WarningWatch watch;
  Read result{read_mtl("newmtl m\n" + statements, "a.mtl"), {}};
  result.warnings = watch.texts();
  EXPECT_FALSE(result.materials.empty());
  return result;
}

MtlMaterial silently(const std::string& statements) {
  const Read result = read(statements);
  EXPECT_TRUE(result.warnings.empty()) << statements << " -> " << result.warnings.front();
  return result.materials.front();
}

// Of the one warning: where, what, and what is used instead.
MtlMaterial warned(const std::string& statements, const std::vector<std::string>& says) {
  const Read result = read(statements);
  EXPECT_EQ(result.warnings.size(), 1u) << statements;
  const std::string warning = result.warnings.empty() ? "" : result.warnings[0];
  for (const std::string& text : says) EXPECT_NE(warning.find(text), std::string::npos) << statements << " -> " << warning;
  return result.materials.front();
}

TEST(Mtl, NumbersAsTheFormatHasThem) {
  EXPECT_EQ(silently("").diffuse, vec3(0.6f));
  EXPECT_EQ(silently("Kd 0.25").diffuse, vec3(0.25f)) << "one number stands for three";
  EXPECT_EQ(silently("Kd .5 1. +1e-1 # brick").diffuse, vec3(0.5f, 1.0f, 0.1f));
  EXPECT_EQ(silently("kd 1 0 0").diffuse, vec3(1, 0, 0));
  EXPECT_EQ(silently("Kd 1 0 0 1").diffuse, vec3(1, 0, 0));
  EXPECT_EQ(silently("Kd -1 0 0").diffuse, vec3(0.0f));
  EXPECT_EQ(silently("Ns 0").shininess, 1.0f);
  EXPECT_EQ(silently("Tr 0.25").dissolve, 0.75f);
  EXPECT_EQ(silently("Tr 1\nd 0.75").dissolve, 0.75f);
  EXPECT_EQ(silently("d 0.75\nTr 1").dissolve, 0.75f) << "d goes before Tr in either order";
  EXPECT_EQ(silently("Ka spectral a.rfl\nNi x\nillum many").dissolve, 1.0f) << "what is not used is not checked";
}

TEST(Mtl, NumbersOutOfRangeAreSaid) {
  EXPECT_EQ(warned("d 2", {"a.mtl:2: d: is 2", "valid: 0 to 1; 1 is used"}).dissolve, 1.0f);
  EXPECT_EQ(warned("d -1", {"a.mtl:2: d: is -1", "0 is used"}).dissolve, 0.0f);
  EXPECT_EQ(warned("Tr 30", {"a.mtl:2: Tr: is 30"}).dissolve, 0.0f);
  EXPECT_EQ(warned("Kd 255 128 0", {"a.mtl:2: Kd 255 128 0: ", "valid: 0 to 1"}).diffuse, vec3(255, 128, 0));
}

TEST(Mtl, UnknownKeywordsAreSummedUp) {
  warned("mapKd a.png\nKdd 1 0 0\nmap_alhpa b.png\nKdd 1 1 0",
         {"a.mtl:2: ", "Kdd (line 3)", "mapKd (line 2)", "map_alhpa (line 4)"});
  silently("illum 2\nPr 0.5\nmap_Ns a.png\nmap_Pm b.png\nrefl c.png\nTf 1 1 1\nsharpness 60");
}

TEST(Mtl, OpacityByOtherNames) {
  EXPECT_EQ(silently("map_opacity a.png").alpha.name, "a.png");
  EXPECT_FALSE(silently("map_opacity a.png").alpha.inverted);
  EXPECT_TRUE(silently("map_Tr -clamp on a.png").alpha.inverted);
  EXPECT_EQ(silently("map_Tr a.png").alpha.name, "a.png");
}

TEST(Mtl, ColoursOfCieXyzAreConverted) {
  const vec3 white = silently("Kd xyz 0.9505 1 1.089").diffuse;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0f, 1e-3f);
  const vec3 red = silently("Kd xyz 0.4124 0.2126 0.0193").diffuse;
  EXPECT_NEAR(red.x, 1.0f, 1e-3f);
  EXPECT_NEAR(red.y, 0.0f, 1e-3f);
}

TEST(Mtl, DecimalCommasAreReadAndSaid) {
  EXPECT_EQ(warned("Kd 1,0 0,5 0,25", {"a.mtl:2: Kd: ", "decimal"}).diffuse, vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(warned("\nNs 12,5", {"a.mtl:3: Ns: "}).shininess, 12.5f);
  EXPECT_EQ(warned("d 0,5", {"a.mtl:2: d: "}).dissolve, 0.5f);
  const MtlPicture picture = warned("map_Kd -s 2,5 2,5 1 -o 0,5 0 0 a,b.png", {"a.mtl:2: map_Kd: "}).colour;
  EXPECT_EQ(picture.scale, vec2(2.5f));
  EXPECT_EQ(picture.offset, vec2(0.5f, 0.0f));
  EXPECT_EQ(picture.name, "a,b.png");
}

TEST(Mtl, WhatIsNoColourIsSaidWithItsReplacement) {
  for (const std::string text :
       {"Kd a b c", "Kd 1,0,0 1 1", "Kd 0.5, 0.5, 0.5", "Kd nan 0 0", "Kd 1e999 0 0", "Kd", "Kd 1 0"}) {
    EXPECT_EQ(warned(text, {"a.mtl:2: Kd", "0.6 0.6 0.6 is used instead"}).diffuse, vec3(0.6f)) << text;
  }
  EXPECT_EQ(warned("Kd 1 0 0\nKd spectral a.rfl 1", {"a.mtl:3: Kd spectral", "1 0 0 is used instead"}).diffuse, vec3(1, 0, 0));
  EXPECT_EQ(warned("Ks x y z", {"a.mtl:2: Ks", "0 0 0 is used instead"}).specular, vec3(0.0f));
  EXPECT_EQ(warned("Ns abc", {"a.mtl:2: Ns", "1 is used instead"}).shininess, 1.0f);
  EXPECT_EQ(warned("d", {"a.mtl:2: d", "1 is used instead"}).dissolve, 1.0f);
  EXPECT_EQ(warned("Tr x", {"a.mtl:2: Tr"}).dissolve, 1.0f);
  EXPECT_EQ(warned("d -halo 0.5", {"a.mtl:2: d -halo"}).dissolve, 0.5f);
}

TEST(Mtl, OptionsOfPictures) {
  const MtlPicture all =
      silently(
          "map_Kd -blendu on -blendv off -cc on -clamp on -boost 2 -texres 512 -mm 0 1 -t 0 0 0 -imfchan r -s 2 3 4 -o "
          "0.5 0.25 0 -bm 0.5 my picture 01.png  ")
          .colour;
  EXPECT_EQ(all.name, "my picture 01.png");
  EXPECT_EQ(all.scale, vec2(2, 3));
  EXPECT_EQ(all.offset, vec2(0.5f, 0.25f));
  EXPECT_EQ(all.bump_multiplier, 0.5f);
  EXPECT_TRUE(all.clamp);
  // Fewer numbers than three: the picture's name is none of them.
  EXPECT_EQ(silently("map_Kd -s 2 2 a.png").colour.name, "a.png");
  EXPECT_EQ(silently("map_Kd -s 2 2 a.png").colour.scale, vec2(2.0f));
  EXPECT_EQ(silently("map_Kd -s 2 a.png").colour.scale, vec2(2, 1));
  EXPECT_EQ(silently("map_Kd -o 1 1 7").colour.name, "7");
  EXPECT_EQ(silently("map_Kd -marble.png").colour.name, "-marble.png");
  EXPECT_EQ(silently("map_Kd").colour.name, "");
  EXPECT_EQ(silently("map_Kd C:\\a\\b #1.png").colour.name, "C:\\a\\b #1.png");
}

TEST(Mtl, OptionsWithoutTheirNumberAreSaid) {
  EXPECT_EQ(warned("map_Bump -bm a.png", {"a.mtl:2: map_Bump -bm"}).bump.name, "a.png");
  EXPECT_EQ(warned("bump -bm x a.png", {"a.mtl:2: bump -bm"}).bump.bump_multiplier, 1.0f);
  EXPECT_EQ(warned("norm -s", {"a.mtl:2: norm -s"}).normal.scale, vec2(1.0f));
  EXPECT_EQ(warned("map_d -mm 1 a.png", {"a.mtl:2: map_d -mm"}).alpha.name, "a.png");
}

TEST(Mtl, SeveralMaterials) {
  const auto materials =
      read_mtl("\xef\xbb\xbf# comment\r\nKd 1 0 0\r\nnewmtl a b \r\nd 0.5\r\nnewmtl Material#25\r\nTr 0.25\r\n", "a.mtl");
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].name, "a b");
  EXPECT_EQ(materials[0].diffuse, vec3(0.6f)) << "what stands before the first is of none";
  EXPECT_EQ(materials[1].name, "Material#25");
  EXPECT_EQ(materials[1].dissolve, 0.75f) << "the d of another material does not count";
}

}  // namespace
}  // namespace gnomon
