// Buffers and pictures of glTF files in another case of letters or folder, and floods of warnings.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;

TEST(GltfFiles, BuffersAndPicturesInAnotherCaseOfLetters) {
  const test_files::Folder folder;
  folder.picture("Red.PNG", 1, 1, [](int, int) { return std::array<uint8_t, 4>{77, 0, 0, 255}; });
  GltfBuilder b;
  b.triangle();
  b.root["meshes"][0]["primitives"][0]["material"] = 0;
  b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.add("textures", {{"source", 0}});
  b.add("images", {{"uri", "maps%5Cred.png"}});
  b.root["buffers"][0] = {{"byteLength", b.data.size()}, {"uri", "MESH.bin"}};
  write_file(folder.path() / "mesh.BIN", b.data);
  const Scene scene = GltfBuilder::load_text(b.root.dump(), folder.path());
  EXPECT_EQ(scene.triangle_count(), 1u);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].image.rgba[0], 77);
}

TEST(GltfFiles, FilesThatWereNotFetched) {
  const test_files::Folder folder;
  GltfBuilder b;
  b.triangle();
  b.root["buffers"][0] = {{"byteLength", b.data.size()}, {"uri", "mesh.bin"}};
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
  for (const std::string name : {"mesh.bin", "scene.gltf"}) {
    write_file(folder.path() / "scene.gltf", b.root.dump());
    write_file(folder.path() / name, pointer);
    try {
      load_scene((folder.path() / "scene.gltf").string());
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(name + ": is a Git LFS pointer"), std::string::npos) << error.what();
    }
  }
}

TEST(GltfFiles, ThreeThousandPointPrimitivesAreCounted) {
  const test_files::Folder folder;
  GltfBuilder b;
  b.triangle();
  const auto triangle = b.root["meshes"][0]["primitives"][0];
  for (int i = 0; i < 3000; ++i) {
    b.root["meshes"][0]["primitives"].push_back(triangle);
    b.root["meshes"][0]["primitives"].back()["mode"] = 0;
  }
  write_file(folder.path() / "scene.gltf", b.gltf());
  const WarningWatch watch;
  EXPECT_EQ(load_scene((folder.path() / "scene.gltf").string()).triangle_count(), 1u);
  const auto texts = watch.texts();
  ASSERT_FALSE(texts.empty());
  EXPECT_LT(texts.size(), 10u);
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const auto& text) { return text.starts_with("and 2995 more"); }))
      << texts.back();
}

}  // namespace
}  // namespace gnomon
