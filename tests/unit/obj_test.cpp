// OBJ and MTL: every statement that is read, odd files, and errors that name the line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "base/error.h"
#include "base/file.h"
#include "base/image.h"
#include "scene/load.h"
#include "scene_files.h"

namespace gnomon {
namespace {

Scene load(const std::string& text, const std::filesystem::path& folder = {}) {
  return load_obj_from_memory(text, "test.obj", folder);
}

constexpr const char* k_quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

const MeshPart& only_part(const Scene& scene) {
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes.at(0).parts.size(), 1u);
  return scene.meshes.at(0).parts.at(0);
}

TEST(Obj, QuadWithEverything) {
  const Scene scene = load(std::string(k_quad) + "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
  EXPECT_EQ(scene.name, "test.obj");
  EXPECT_EQ(scene.source, "test.obj");
  const MeshPart& part = only_part(scene);
  ASSERT_EQ(part.triangle_count(), 2u);
  ASSERT_EQ(part.positions.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(part.normals[i], vec3(0, 0, 1));
    EXPECT_EQ(part.uvs[i], vec2(part.positions[i].x, 1.0f - part.positions[i].y)) << "v runs downward";
    EXPECT_EQ(part.colours[i], vec4(1.0f));
    EXPECT_EQ(part.tangents[i], vec4(1, 0, 0, 1));
  }
  EXPECT_NEAR(test_files::area(part), 1.0, 1e-6);
  EXPECT_NO_THROW(check_scene(scene));
}

TEST(Obj, AllFormsOfCornersAndIndices) {
  const std::string expected = load(std::string(k_quad) + "f 1/1/1 2/2/1 3/3/1\n").content_hash();
  EXPECT_EQ(load(std::string(k_quad) + "f -4/-4/-1 -3/-3/-1 -2/-2/-1\n").content_hash(), expected);
  EXPECT_EQ(load(std::string(k_quad) + "f 1/1/-1 -3/2/1 3/-2/1 # comment\n").content_hash(), expected);
  EXPECT_EQ(load(std::string(k_quad) + "f 1/1/1 \\\n 2/2/1 \\\n 3/3/1\n").content_hash(), expected);
  EXPECT_EQ(load("\xef\xbb\xbf" + std::string(k_quad) + "\tf\t1/1/1  2/2/1\t3/3/1   ").content_hash(), expected);
  // Vertices may come after the faces that name them.
  EXPECT_EQ(load("f 1/1/1 2/2/1 3/3/1\n" + std::string(k_quad)).content_hash(), expected);
  std::string dos = std::string(k_quad) + "f 1/1/1 2/2/1 3/3/1\n", mac = dos;
  for (size_t i = 0; (i = dos.find('\n', i)) != dos.npos; i += 2) dos.insert(i, "\r");
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  EXPECT_EQ(load(dos).content_hash(), expected);
  EXPECT_EQ(load(mac).content_hash(), expected);

  EXPECT_EQ(only_part(load(std::string(k_quad) + "f 1 2 3\n")).uvs[0], vec2(0.0f));
  EXPECT_EQ(only_part(load(std::string(k_quad) + "f 1//1 2//1 3//1\n")).normals[0], vec3(0, 0, 1));
  EXPECT_EQ(only_part(load(std::string(k_quad) + "f 1// 2// 3//\n")).normals[0], vec3(0, 0, 1)) << "made";
  EXPECT_EQ(only_part(load(std::string(k_quad) + "f 1/1/ 2/2/ 3/3/\n")).triangle_count(), 1u);
}

TEST(Obj, NegativeIndicesCountFromTheirOwnLine) {
  const Scene scene = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf -3 -2 -1\n");
  EXPECT_EQ(scene.triangle_count(), 2u);
  EXPECT_EQ(scene.bounds().max.z, 5.0f);
  EXPECT_EQ(only_part(scene).positions.size(), 6u);
}

TEST(Obj, NumbersInTheirOddSpellings) {
  const MeshPart part = only_part(load("v .5 -.5 +1\nv 2. 1e+2 1E-2\nv 1e-50 -0 3\nf 1 2 3\n"));
  const Box box = Mesh{"", {part}}.bounds();
  EXPECT_EQ(box.min, vec3(0, -0.5f, 0.01f));
  EXPECT_EQ(box.max, vec3(2, 100, 3));
}

TEST(Obj, VertexColours) {
  const MeshPart part = only_part(load("v 0 0 0 1 0.5 0\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3\n"));
  for (size_t i = 0; i < 3; ++i) {
    const vec4 expected = part.positions[i].x > 0 ? vec4(0, 1, 0, 1) : part.positions[i].y > 0 ? vec4(1) : vec4(1, 0.5f, 0, 1);
    EXPECT_EQ(part.colours[i], expected);
  }
  EXPECT_EQ(only_part(load("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n")).colours[0], vec4(1.0f))
      << "a fourth number is a weight";
}

TEST(Obj, ConcavePolygonsCoverTheirAreaOnce) {
  // An L, an arrow and a comb, each in several planes and windings.
  const std::vector<std::vector<vec2>> shapes = {
      {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
      {{0, 0}, {2, 1}, {0, 2}, {0.5f, 1}},
      {{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {5, 1}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {0, 3}}};
  const std::vector<double> areas = {3, 1.5, 17};
  for (size_t s = 0; s < shapes.size(); ++s) {
    for (int plane = 0; plane < 3; ++plane) {
      for (const bool reversed : {false, true}) {
        std::string text, face = "f";
        for (size_t i = 0; i < shapes[s].size(); ++i) {
          vec3 p(0.0f);
          p[(plane + 1) % 3] = shapes[s][i].x + 14678, p[(plane + 2) % 3] = shapes[s][i].y - 9605;
          text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
          face += fmt::format(" {}", reversed ? shapes[s].size() - i : i + 1);
        }
        const MeshPart part = only_part(load(text + face + "\n"));
        EXPECT_EQ(part.triangle_count(), shapes[s].size() - 2);
        EXPECT_NEAR(test_files::area(part), areas[s], 1e-2) << "shape " << s << " plane " << plane;
        for (const vec3& n : part.normals) EXPECT_NEAR(n[plane], reversed ? -1.0f : 1.0f, 1e-5f);
      }
    }
  }
}

TEST(Obj, UnitQuadsFarFromTheOrigin) {
  std::string text;
  for (int i = 0; i < 14; ++i) {
    text += fmt::format("v 14678 {0} 9605\nv 14679 {0} 9605\nv 14679 {0} 9606\nv 14678 {0} 9606\nf -1 -2 -3 -4\n", i);
  }
  const MeshPart part = only_part(load(text));
  EXPECT_EQ(part.triangle_count(), 28u);
  EXPECT_NEAR(test_files::area(part), 14.0, 1e-6);
  for (const vec3& n : part.normals) EXPECT_EQ(n, vec3(0, 1, 0));
}

TEST(Obj, GroupsBecomeObjectsAndMaterialsParts) {
  const Scene scene = load(std::string(k_quad) +
                           "f 1 2 3\n"
                           "o house\nusemtl brick\nf 1 2 3\nusemtl glass\nf 1 3 4\nusemtl brick\nf 2 3 4\n"
                           "g roof\nf 1 2 4\n"
                           "o house two\nf 1 2 3\n"
                           "g\nf 1 2 4\n"
                           "o empty\n"
                           "o house\nusemtl glass\nf 1 2 3\n");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  EXPECT_EQ(names, (std::vector<std::string>{"test.obj", "house", "house/roof", "house two"}));
  EXPECT_EQ(scene.meshes[1].parts.size(), 2u) << "a group that goes on later is one object";
  EXPECT_EQ(scene.meshes[1].parts[0].triangle_count(), 2u);
  EXPECT_EQ(scene.meshes[1].parts[1].triangle_count(), 2u);
  EXPECT_EQ(scene.materials[static_cast<size_t>(scene.meshes[1].parts[0].material)].name, "brick");
  EXPECT_EQ(scene.materials[static_cast<size_t>(scene.meshes[0].parts[0].material)].name, "default");
  EXPECT_EQ(scene.triangle_count(), 8u);
}

TEST(Obj, MissingNormalsAreMadeBesideGivenOnes) {
  const Scene scene =
      load(std::string(k_quad) + "v 0 0 -1\nv 1 0 -1\nvn 0 0 0\nf 1//1 2//1 3//1 4//1\nf 1 5 6 2\nf 1//2 2//2 3//2\n");
  EXPECT_EQ(scene.meshes[0].parts.size(), 2u);
  for (const MeshPart& part : scene.meshes[0].parts) {
    for (const vec3& n : part.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
  }
  EXPECT_EQ(scene.triangle_count(), 5u);
}

TEST(Obj, FacesWithTooFewCornersAreLeftOut) {
  EXPECT_EQ(load(std::string(k_quad) + "f 1\nf 1 2\nf\nf 1 2 3\nl 1 2\np 1\n").triangle_count(), 1u);
  EXPECT_EQ(load(std::string(k_quad) + "l 1 2\n").objects.size(), 0u);
}

// --- errors ---

std::string error_of(const std::string& text) {
  try {
    load(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Obj, ErrorsNameTheLineAndWhatIsValid) {
  const std::string quad = k_quad;  // nine lines
  const std::vector<std::array<std::string, 3>> cases = {
      {"f 1 2 5\n", "test.obj:10: ", "valid: 1 to 4"},
      {"\n# comment\nf 1 2 0\n", "test.obj:12: ", "valid: 1 to 4"},
      {"f 1 2 -5\n", "test.obj:10: ", "-4 to -1"},
      {"f 1/x 2/1 3/1\n", "test.obj:10: ", "v/vt/vn"},
      {"f 1 2 three\n", "test.obj:10: ", "v/vt/vn"},
      {"f 1 2 3.5\n", "test.obj:10: ", "v/vt/vn"},
      {"f 1/1/1/1 2 3\n", "test.obj:10: ", "v/vt/vn"},
      {"f 1 2 99999999999999999999999\n", "test.obj:10: ", "out of range"},
      {"f 1 2 -9223372036854775808\n", "test.obj:10: ", "out of range"},
      {"v 1 2\n", "test.obj:10: ", "at least 3"},
      {"v 1 nan 2\n", "test.obj:10: ", "\"nan\""},
      {"v 1 -inf 2\n", "test.obj:10: ", "\"-inf\""},
      {"v 1 1e39 2\n", "test.obj:10: ", "finite"},
      {"v 1 1e999 2\n", "test.obj:10: ", "finite"},
      {"v 1 2,5 2\n", "test.obj:10: ", "\"2,5\""},
      {"v 3.1+e2 1 1\n", "test.obj:10: ", "finite"},
      {"vt x 1\n", "test.obj:10: ", "\"x\""},
      {"vn 1 2\n", "test.obj:10: ", "at least 3"},
      {"v 1 2 \\\n nan\n", "test.obj:10: ", "\"nan\""},
  };
  for (const auto& [text, place, valid] : cases) {
    const std::string message = error_of(quad + text);
    EXPECT_TRUE(message.starts_with(place)) << text << " -> " << message;
    EXPECT_NE(message.find(valid), std::string::npos) << text << " -> " << message;
  }
  EXPECT_TRUE(error_of("").starts_with("test.obj:1: "));
  EXPECT_TRUE(error_of("# nothing\n").starts_with("test.obj:1: "));
  EXPECT_TRUE(error_of("f 1 2 3\n").starts_with("test.obj:1: vertex index 1"));
  EXPECT_TRUE(error_of(std::string("\xff\xfe\0v", 4)).starts_with("test.obj:1: UTF-16"));
}

TEST(Obj, HugePolygonsEndInTime) {
  // Convex with 200000 corners: a fan. Concave: refused, since clipping takes quadratic time.
  std::string convex, concave, face = "f";
  constexpr int k_corners = 20000;
  for (int i = 0; i < k_corners; ++i) {
    const double a = i * 2.0 * glm::pi<double>() / k_corners, r = i % 2 ? 1.0 : 0.5;
    convex += fmt::format("v {} {} 0\n", 1e3 * std::cos(a), 1e3 * std::sin(a));
    concave += fmt::format("v {} {} 0\n", r * std::cos(a), r * std::sin(a));
    face += fmt::format(" {}", i + 1);
  }
  const std::string message = error_of(concave + face);
  EXPECT_TRUE(message.starts_with(fmt::format("test.obj:{}: a concave polygon", k_corners + 1))) << message;
  convex = "v 0 0 0\nv 1 0 0\nv 1 1 0\n", face = "f 1 2";
  for (int i = 0; i < k_corners; ++i) face += " 3";
  EXPECT_EQ(load(convex + face + "\n").triangle_count(), 1u);
}

TEST(Obj, EveryTruncationLoadsOrFails) {
  const std::string text = "mtllib a.mtl\no a\n" + std::string(k_quad) + "usemtl b\nf 1/1/1 2/2/1 3/3/1 4/4/1\nf -4 -3 -2\n";
  for (size_t length = 0; length <= text.size(); ++length) {
    try {
      check_scene(load(text.substr(0, length)));
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("test.obj:")) << error.what();
    }
  }
}

// --- materials ---

class ObjMaterials : public ::testing::Test {
 protected:
  void picture(const std::string& name, int width, int height, const std::function<std::array<uint8_t, 4>(int, int)>& colour) {
    folder_.picture(name, width, height, colour);
  }
  Scene load_with(const std::string& mtl, const std::string& name = "m") {
    write_file(folder_.path() / "lib.mtl", mtl);
    return load("mtllib lib.mtl\n" + std::string(k_quad) + "usemtl " + name + "\nf 1/1 2/2 3/3\n", folder_.path());
  }
  const Image8& base_picture(const Scene& scene) {
    return scene.textures.at(static_cast<size_t>(scene.materials.at(0).base_colour_texture)).image;
  }

  test_files::Folder folder_;
};

TEST_F(ObjMaterials, ColoursAndNumbers) {
  const Scene scene = load_with("newmtl other\nKd 1 0 0\nnewmtl m\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nNs 77\nKe 1 2 3\nd 0.5\n");
  ASSERT_EQ(scene.materials.size(), 1u) << "only what is used";
  const Material& m = scene.materials[0];
  EXPECT_EQ(m.name, "m");
  EXPECT_EQ(m.base_colour, vec4(0.1f, 0.2f, 0.3f, 0.5f));
  EXPECT_EQ(m.specular, vec3(0.4f, 0.5f, 0.6f));
  EXPECT_EQ(m.shininess, 77.0f);
  EXPECT_EQ(m.emissive, vec3(1, 2, 3));
  EXPECT_FALSE(m.masked);
  EXPECT_TRUE(m.double_sided) << "OBJ knows no culling";
}

TEST_F(ObjMaterials, NamesWithBlanks) {
  picture("my picture 01.png", 2, 2, [](int, int) { return std::array<uint8_t, 4>{10, 20, 30, 255}; });
  const Scene scene = load_with("newmtl my material\nKd 1 1 1\nmap_Kd my picture 01.png\n", "my material");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].image.rgba[2], 30);
  EXPECT_TRUE(scene.textures[0].srgb);
  write_file(folder_.path() / "a library.mtl", std::string("newmtl m\nKd 0 1 0\n"));
  for (const std::string line : {"mtllib a library.mtl\n", "mtllib absent.mtl a\\ library.mtl\n"}) {
    EXPECT_EQ(load(line + std::string(k_quad) + "usemtl m\nf 1 2 3\n", folder_.path()).materials[0].base_colour,
              vec4(0, 1, 0, 1))
        << line;
  }
}

TEST_F(ObjMaterials, WindowsPathsAreFoundBesideTheModel) {
  std::filesystem::create_directory(folder_.path() / "maps");
  picture("maps/a.png", 2, 2, [](int, int) { return std::array<uint8_t, 4>{1, 2, 3, 255}; });
  picture("b.png", 2, 2, [](int, int) { return std::array<uint8_t, 4>{4, 5, 6, 255}; });
  EXPECT_EQ(base_picture(load_with("newmtl m\nmap_Kd maps\\a.png\n")).rgba[0], 1);
  EXPECT_EQ(base_picture(load_with("newmtl m\nmap_Kd C:\\Users\\me\\b.png\n")).rgba[0], 4);
}

TEST_F(ObjMaterials, AlphaOfTheColourPictureMasks) {
  picture("leaf.png", 4, 4, [](int x, int) {
    return std::array<uint8_t, 4>{0, 255, 0, static_cast<uint8_t>(x < 2 ? 0 : 255)};
  });
  for (const std::string mtl : {"newmtl m\nmap_Kd leaf.png\n", "newmtl m\nmap_Kd leaf.png\nmap_d leaf.png\nd 0\n"}) {
    const Scene scene = load_with(mtl);
    EXPECT_TRUE(scene.materials[0].masked);
    EXPECT_TRUE(scene.materials[0].double_sided) << "foliage is seen from both sides";
    EXPECT_EQ(scene.materials[0].base_colour.w, 1.0f);
    EXPECT_EQ(base_picture(scene).at(0, 0)[3], 0);
    EXPECT_EQ(base_picture(scene).at(3, 0)[3], 255);
  }
}

TEST_F(ObjMaterials, AMaskOfAnotherSizeIsResampled) {
  picture("colour.png", 8, 4, [](int, int) { return std::array<uint8_t, 4>{200, 100, 50, 255}; });
  picture("mask.png", 2, 2, [](int x, int) {
    return x == 0 ? std::array<uint8_t, 4>{0, 0, 0, 255} : std::array<uint8_t, 4>{255, 255, 255, 255};
  });
  const Scene scene = load_with("newmtl m\nmap_Kd colour.png\nmap_d mask.png\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  const Image8& image = base_picture(scene);
  ASSERT_EQ(image.width, 8);
  EXPECT_EQ(image.at(0, 0)[0], 200);
  EXPECT_EQ(image.at(0, 0)[3], 0);
  EXPECT_EQ(image.at(1, 3)[3], 0);
  EXPECT_LT(image.at(3, 1)[3], 128);
  EXPECT_GT(image.at(4, 1)[3], 128);
  EXPECT_EQ(image.at(7, 2)[3], 255);
  EXPECT_TRUE(scene.materials[0].masked);
}

TEST_F(ObjMaterials, AMaskWithoutColourPicture) {
  picture("mask.png", 2, 1, [](int x, int) {
    return x == 0 ? std::array<uint8_t, 4>{0, 0, 0, 255} : std::array<uint8_t, 4>{255, 255, 255, 255};
  });
  const Scene scene = load_with("newmtl m\nKd 0.5 0.5 0.5\nmap_d mask.png\n");
  EXPECT_TRUE(scene.materials[0].masked);
  EXPECT_EQ(base_picture(scene).at(0, 0)[0], 255);
  EXPECT_EQ(base_picture(scene).at(0, 0)[3], 0);
  EXPECT_EQ(scene.materials[0].base_colour.x, 0.5f);
}

TEST_F(ObjMaterials, BlackBesideAPictureMeansThePicture) {
  picture("a.png", 1, 1, [](int, int) { return std::array<uint8_t, 4>{9, 9, 9, 255}; });
  EXPECT_EQ(load_with("newmtl m\nKd 0 0 0\nmap_Kd a.png\n").materials[0].base_colour, vec4(1.0f));
  EXPECT_EQ(load_with("newmtl m\nKd 0.5 0.25 0\nmap_Kd a.png\n").materials[0].base_colour, vec4(0.5f, 0.25f, 0, 1));
}

TEST_F(ObjMaterials, NormalMapsAndHeightMaps) {
  picture("normal.png", 2, 2, [](int, int) { return std::array<uint8_t, 4>{128, 128, 255, 255}; });
  // A ridge: height rises to the right, then wraps.
  picture("height.png", 8, 8, [](int x, int) {
    const auto h = static_cast<uint8_t>(x * 10);
    return std::array<uint8_t, 4>{h, h, h, 255};
  });
  picture("slope.png", 8, 8, [](int, int y) {
    const auto h = static_cast<uint8_t>(y * 10);
    return std::array<uint8_t, 4>{h, h, h, 255};
  });
  const auto normal_texture = [&](const std::string& statement) {
    const Scene scene = load_with("newmtl m\n" + statement + "\n");
    const Texture& texture = scene.textures.at(static_cast<size_t>(scene.materials[0].normal_texture));
    EXPECT_FALSE(texture.srgb);
    return texture.image;
  };
  for (const std::string statement : {"norm normal.png", "map_bump normal.png", "bump normal.png"}) {
    EXPECT_EQ(normal_texture(statement).rgba[2], 255) << statement;
    EXPECT_EQ(normal_texture(statement).rgba[0], 128) << statement;
  }
  const Image8 rise = normal_texture("map_bump height.png");
  EXPECT_LT(rise.at(4, 4)[0], 120) << "a surface that rises to the right looks to the left";
  EXPECT_NEAR(rise.at(4, 4)[1], 128, 1);
  EXPECT_GT(rise.at(0, 4)[0], 136) << "the edge wraps";
  const Image8 down = normal_texture("bump slope.png");
  EXPECT_GT(down.at(4, 4)[1], 136) << "a surface that rises downward looks up";
  const Image8 strong = normal_texture("map_bump -bm 3 height.png");
  EXPECT_LT(strong.at(4, 4)[0], rise.at(4, 4)[0]);
}

TEST_F(ObjMaterials, ScaleOffsetAndClamp) {
  picture("a.png", 1, 1, [](int, int) { return std::array<uint8_t, 4>{9, 9, 9, 255}; });
  const Scene scene = load_with("newmtl m\nmap_Kd -s 2 4 1 -o 0.5 0.25 0 -clamp on a.png\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].wrap_u, Wrap::clamp);
  // OBJ: u' = 0.5 + 2 u, v' = 0.25 + 4 v with v upward; here v is 1 - v.
  const vec2 uv = scene.materials[0].base_colour_uv.apply({0.25f, 1.0f - 0.125f});
  EXPECT_NEAR(uv.x, 1.0f, 1e-6f);
  EXPECT_NEAR(uv.y, 1.0f - 0.75f, 1e-6f);
}

TEST_F(ObjMaterials, WhatIsMissingKeepsTheColour) {
  const Scene scene = load_with("newmtl m\nKd 0.2 0.4 0.6\nmap_Kd absent.png\nmap_d absent too.png\nnorm gone.png\n");
  EXPECT_EQ(scene.materials[0].base_colour, vec4(0.2f, 0.4f, 0.6f, 1));
  EXPECT_EQ(scene.materials[0].base_colour_texture, k_no_texture);
  EXPECT_FALSE(scene.materials[0].masked);
  EXPECT_TRUE(scene.textures.empty());
  write_file(folder_.path() / "broken.png", std::string("not a picture"));
  EXPECT_EQ(load_with("newmtl m\nKd 0.2 0.4 0.6\nmap_Kd broken.png\n").materials[0].base_colour_texture, k_no_texture);
  EXPECT_EQ(load("mtllib absent.mtl\n" + std::string(k_quad) + "usemtl x\nf 1 2 3\n", folder_.path()).materials[0].name, "x");
}

TEST_F(ObjMaterials, PicturesAreShared) {
  picture("a.png", 2, 2, [](int, int) { return std::array<uint8_t, 4>{9, 9, 9, 255}; });
  write_file(folder_.path() / "lib.mtl", std::string("newmtl m\nmap_Kd a.png\nnewmtl n\nmap_Kd a.png\nKd 1 0 0\n"));
  const Scene scene = load(
      "mtllib lib.mtl\n" + std::string(k_quad) + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\nusemtl n\nf 1/1 3/1 4/1\n", folder_.path());
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.textures.size(), 1u);
}

TEST_F(ObjMaterials, MtlNumbersThatAreNoneAreHarmless) {
  const Scene scene = load_with("newmtl m\nKd nan 1e999 -5\nKs x y z\nNs -3\nd 1e99999\nKe\nmap_Kd\nmap_bump -bm\nnorm -s\n");
  EXPECT_NO_THROW(check_scene(scene));
}

TEST(ObjFile, LoadsByPathAndFindsItsLibraryThere) {
  test_files::Folder folder;
  write_file(folder.path() / "lib.mtl", std::string("newmtl m\nKd 0 0 1\n"));
  write_file(folder.path() / "scene.OBJ", "mtllib lib.mtl\n" + std::string(k_quad) + "usemtl m\nf 1 2 3\n");
  const Scene scene = load_scene((folder.path() / "scene.OBJ").string());
  EXPECT_EQ(scene.name, "scene.OBJ");
  EXPECT_EQ(scene.materials[0].base_colour, vec4(0, 0, 1, 1));
}

}  // namespace
}  // namespace gnomon
