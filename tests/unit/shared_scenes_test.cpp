// The scene files kept beside the repository: each loads and says what it should. Skipped where the folder is not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "scene/load.h"
#include "scene_files.h"
#include "support/paths.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class SharedScenes : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }
  Scene load(const std::string& path) const { return load_scene((folder_ / path).string()); }

  const fs::path folder_ = shared_scenes();
};

size_t masked_count(const Scene& scene) {
  return static_cast<size_t>(
      std::count_if(scene.materials.begin(), scene.materials.end(), [](const Material& m) { return m.masked; }));
}

TEST_F(SharedScenes, EveryMalformedFileDoesAsTheIndexSays) {
  std::ifstream index(folder_ / "malformed/INDEX.tsv");
  std::string line;
  std::getline(index, line);  // titles
  int count = 0;
  while (std::getline(index, line)) {
    std::vector<std::string> fields;
    std::istringstream columns(line);
    for (std::string field; std::getline(columns, field, '\t');) fields.push_back(field);
    ASSERT_EQ(fields.size(), 5u) << line;
    const std::string path = (folder_ / "malformed" / fields[0]).string();
    std::string outcome = "accept", message;
    try {
      check_scene(load_scene(path));
    } catch (const Error& error) {
      outcome = "reject", message = error.what();
      // "path: place: what", or "path:line: what".
      ASSERT_TRUE(message.starts_with(path + ":")) << message;
      const std::string rest = message.substr(path.size() + 1);
      EXPECT_TRUE(path.ends_with(".obj") ? std::isdigit(rest[0]) : rest.find(": ") != rest.npos) << message;
    }
    if (fields[4] != "either") {
      EXPECT_EQ(outcome, fields[4]) << fields[0] << " (" << fields[3] << ") " << message;
    }
    ++count;
  }
  EXPECT_GE(count, 40);
}

TEST_F(SharedScenes, Sponza) {
  const Scene obj = load("sponza/sponza.obj"), gltf = load("sponza/sponza.gltf");
  EXPECT_EQ(obj.objects.size(), 382u);
  EXPECT_EQ(gltf.objects.size(), obj.objects.size());
  EXPECT_EQ(obj.materials.size(), 26u);
  EXPECT_EQ(obj.textures.size(), 24u) << "25 are named, gi_flag is not there";
  EXPECT_EQ(masked_count(obj), 3u);
  EXPECT_EQ(masked_count(gltf), 3u);
  EXPECT_NEAR(static_cast<double>(obj.triangle_count()), static_cast<double>(gltf.triangle_count()), 100.0);
  EXPECT_NEAR(test_files::area(obj) * 1e-4, test_files::area(gltf), 1.0) << "the OBJ is in centimetres";
  const Box a = obj.bounds(), b = gltf.bounds();
  EXPECT_LT(glm::distance(a.min * 0.01f, b.min), 0.01f);
  EXPECT_LT(glm::distance(a.max * 0.01f, b.max), 0.01f);
  ASSERT_EQ(gltf.lights.size(), 3u);
  EXPECT_EQ(gltf.lights[2].kind, LightKind::spot);
  ASSERT_EQ(gltf.cameras.size(), 1u);
  EXPECT_EQ(gltf.cameras[0].far, 100.0f);
}

TEST_F(SharedScenes, BothForestsAreTheSameScene) {
  const Scene instanced = load("st_helens/st_helens_forest_instanced.gltf"),
              nodes = load("st_helens/st_helens_forest_nodes.gltf");
  ASSERT_EQ(instanced.objects.size(), 616u);
  ASSERT_EQ(nodes.objects.size(), instanced.objects.size());
  EXPECT_EQ(nodes.triangle_count(), instanced.triangle_count());
  EXPECT_EQ(nodes.content_hash(), instanced.content_hash());
  EXPECT_EQ(masked_count(nodes), 1u);
  EXPECT_EQ(nodes.lights.size(), 1u);
  const Box box = nodes.bounds();
  EXPECT_NEAR(box.min.y, 694.0f, 0.1f);
  EXPECT_NEAR(box.max.y, 2543.0f, 0.1f);
}

TEST_F(SharedScenes, CompressionChangesNoTriangle) {
  const Scene packed = load("compressed/japanese-bridge-garden/scene.glb"),
              plain = load("compressed/japanese-bridge-garden/scene_plain.glb");
  EXPECT_EQ(packed.triangle_count(), plain.triangle_count());
  EXPECT_EQ(packed.content_hash(), plain.content_hash());
  for (const std::string file : {"BoxDraco.gltf", "BoxMeshopt.glb", "BoxMeshopt.gltf"}) {
    const Scene box = load("compressed/boxes/" + file);
    EXPECT_EQ(box.triangle_count(), 12u) << file;
    EXPECT_NEAR(test_files::area(box), 6.0, 1e-3) << file;
  }
  EXPECT_EQ(load("compressed/chess-board.glb").meshes.size(), 8u);
  EXPECT_EQ(load("compressed/heart_draco.glb").triangle_count(), 180u);
  EXPECT_NEAR(load("compressed/pirate.glb").bounds().max.y, 1.904f, 0.01f);
}

TEST_F(SharedScenes, InstancesAndTextureTransforms) {
  EXPECT_EQ(load("compressed/simple-instancing.glb").objects.size(), 125u);
  EXPECT_EQ(load("compressed/24_gpu_instancing/24_gpu_instancing.gltf").objects.size(), 1900u);
  const Scene transforms = load("compressed/textureTransform/TextureTransformTest.gltf");
  const auto material = [&](const std::string& name) {
    return *std::find_if(transforms.materials.begin(), transforms.materials.end(),
                         [&](const Material& m) { return m.name == name; });
  };
  EXPECT_EQ(material("Offset U").base_colour_uv.apply({0, 0}), vec2(0.5f, 0));
  EXPECT_NE(material("Rotation").base_colour_uv.row_u.y, 0.0f);
  EXPECT_EQ(material("Correct").base_colour_uv.apply({0.25f, 0.75f}), vec2(0.25f, 0.75f));
}

TEST_F(SharedScenes, LightsAndCameras) {
  const Scene lights = load("lights/Lights.glb");
  ASSERT_EQ(lights.lights.size(), 4u);
  EXPECT_EQ(lights.lights[3].kind, LightKind::directional);
  const Scene test = load("lights/gltf_KHR_lights_punctual_test.glb");
  EXPECT_EQ(test.lights.size(), 3u);
  const Scene cameras = load("lights/cameras/Cameras.gltf");
  ASSERT_EQ(cameras.cameras.size(), 2u);
  EXPECT_FALSE(cameras.cameras[0].orthographic);
  EXPECT_TRUE(cameras.cameras[1].orthographic);
  EXPECT_EQ(load("lights/geometry-camera-light.glb").cameras.size(), 2u);
  EXPECT_EQ(load("lights/DepthOfFieldExample.glb").lights.size(), 1u);
}

TEST_F(SharedScenes, FoliageOfObjFilesIsMasked) {
  for (const std::string name : {"antiqueChair", "bicycle", "bonsai-tree", "bush", "christmas_tree", "football-goal"}) {
    const Scene scene = load("alpha_obj/" + name + "/" + name + ".obj");
    EXPECT_GE(masked_count(scene), 1u) << name;
    EXPECT_GT(scene.triangle_count(), 1000u) << name;
    for (const Material& m : scene.materials) EXPECT_TRUE(m.double_sided) << name << " " << m.name;
  }
}

TEST_F(SharedScenes, TheOtherLargeOnes) {
  const Scene map = load("zdm2/zdm2.obj");
  EXPECT_EQ(map.objects.size(), 84u);
  EXPECT_TRUE(map.textures.empty());
  const Scene mountains = load("white_mountains/white_mountains.glb");
  EXPECT_EQ(mountains.triangle_count(), 320000u);
  EXPECT_LT(mountains.meshes[0].parts[0].positions.size(), 170000u) << "terrain without normals stays smooth";
  const Scene ship = load("dutch_ship/dutch_ship_medium_1k.gltf");
  EXPECT_EQ(ship.objects.size(), 3u);
  EXPECT_EQ(ship.textures.size(), 6u) << "pictures of roughness are not read";
  for (const Material& m : ship.materials) EXPECT_NE(m.normal_texture, k_no_texture);
}

}  // namespace
}  // namespace gnomon
