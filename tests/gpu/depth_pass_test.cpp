// Maps of depth drawn from a light, texel by texel, against planes and boxes that can be written down.
#include "frame/casters/caster_draws.h"

#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using glm::dvec3;
using test::device;

constexpr uint32_t k_size = 64;
constexpr float k_half = 2.0f, k_depth = 10.0f;  // the map covers x and z in [-2, 2], from y = 10 (depth 0) down to 0 (depth 1)

mat4 from_above() {
  mat4 clip(0.0f);
  clip[0][0] = 1.0f / k_half;
  clip[2][1] = 1.0f / k_half;
  clip[1][2] = -1.0f / k_depth;
  clip[3] = vec4(0, 0, 1, 1);
  return clip;
}

struct Options {
  bool front_face_culling = false, depth_clamp = false;
};

std::vector<float> depth_map(Scene scene, const Options& options = {}) {
  scene.cameras.push_back(look_at("any", {0, 3, 9}, {0, 0, 0}, 50.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  test::View view(std::move(scene), {16, 16});
  ImageInfo info;
  info.name = "map";
  info.width = info.height = k_size, info.layers = 2;
  info.format = VK_FORMAT_D32_SFLOAT;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const Image map(device(), info);
  const Buffer light(device(), "view", 2 * sizeof(LightView), BufferMemory::upload),
      result(device(), "depths", k_size * k_size * 4);
  for (int layer = 0; layer < 2; ++layer)
    light.mapped_as<LightView>()[layer] = {from_above(), k_view_projective, 0.0f, k_depth, 1};
  light.flush();
  CasterDraws draws(device(), view.gpu_scene(), "light", {.depth_clamp = options.depth_clamp, .layers = 2});
  test::run_passes([&](Recorder& recorder) {
    draws.record(recorder, "light", {&light, 0, sizeof(LightView), 2}, CasterCulling::clusters, options.front_face_culling,
                 map);
    recorder.pass("copy", PassStage::other, {{map, Use::copy_read}, {result, Use::copy_write}}, [&](Commands& commands) {
      VkBufferImageCopy region = {};
      region.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 1};
      region.imageExtent = {k_size, k_size, 1};
      vkCmdCopyImageToBuffer(commands.handle(), map.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, result.handle(), 1,
                             &region);
    });
  });
  return read_back_as<float>(device(), result, k_size * k_size);
}

// World x and z of a texel's centre.
dvec3 texel_centre(uint32_t i) {
  const double x = (i % k_size + 0.5) / k_size * 2.0 - 1.0, z = (i / k_size + 0.5) / k_size * 2.0 - 1.0;
  return {x * k_half, 0, z * k_half};
}

double depth_of(double y) { return 1.0 - y / k_depth; }

TEST(DepthPass, TiltedPlaneHasItsAnalyticDepth) {
  MeshPart part = part_of(0);
  const auto height = [](double x, double z) { return 4.0 + 0.5 * x - 0.25 * z; };
  const auto corner = [&](float x, float z) { return vec3(x, static_cast<float>(height(x, z)), z); };
  add_quad(part, corner(-3, 3), corner(3, 3), corner(3, -3), corner(-3, -3), {0, 0}, {1, 1});
  const auto map = depth_map(test::scene_with({part}));
  double worst = 0.0;
  for (uint32_t i = 0; i < map.size(); ++i) {
    const dvec3 p = texel_centre(i);
    worst = std::max(worst, std::abs(double(map[i]) - depth_of(height(p.x, p.z))));
  }
  // The rasteriser's grid of 1/256 texel tilts the plane by at most that much of its slope.
  EXPECT_LT(worst, 2.0 / 256.0 * (0.5 + 0.25) * (2.0 * k_half / k_size) / k_depth + 1e-6);
}

TEST(DepthPass, NearestCasterWinsAndNothingIsOne) {
  const auto map =
      depth_map(test::scene_with({test::box_part({-1, 1, -1}, {1, 2, 1}), test::box_part({-1, 4, -1}, {0, 5, 1})}));
  for (uint32_t i = 0; i < map.size(); ++i) {
    const dvec3 p = texel_centre(i);
    const bool low = std::abs(p.x) < 1.0 && std::abs(p.z) < 1.0, high = low && p.x < 0.0;
    EXPECT_NEAR(double(map[i]), high ? depth_of(5.0) : low ? depth_of(2.0) : 1.0, 1e-6) << i;
  }
}

TEST(DepthPass, ObjectsThatDoNotCastAreLeftOut) {
  Scene scene = test::scene_with({test::box_part({-1, 1, -1}, {1, 2, 1}), test::box_part({-1, 4, -1}, {0, 5, 1})});
  scene.objects[1].casts = false;
  const auto map = depth_map(std::move(scene));
  EXPECT_NEAR(double(map[k_size / 2 * k_size + k_size / 2 - 4]), depth_of(2.0), 1e-6);
}

// A sheet whose texture is opaque in its left half.
Scene half_sheet(bool masked) {
  Scene scene = test::scene_with({});
  Image8 image(32, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 32; ++x) {
      const uint8_t alpha = x < 16 ? 255 : 0;
      const uint8_t texel[4] = {200, 100, 50, alpha};
      std::copy(texel, texel + 4, image.at(x, y));
    }
  }
  Material material = scene.materials[0];
  material.masked = masked;
  material.base_colour_texture = add_texture(scene, "half", std::move(image), true, Wrap::clamp);
  MeshPart part = part_of(add_material(scene, material));
  add_quad(part, {-1, 3, 1}, {1, 3, 1}, {1, 3, -1}, {-1, 3, -1}, {0, 0}, {1, 1});
  add_object(scene, "sheet", add_mesh(scene, "sheet", {part}));
  return scene;
}

TEST(DepthPass, AlphaTestedCasterHasItsHoles) {
  for (const bool masked : {true, false}) {
    for (const bool front_face_culling : {false, true}) {
      // Front-face culling leaves alpha-tested sheets alone, and takes an opaque one away altogether.
      const auto map = depth_map(half_sheet(masked), {.front_face_culling = front_face_culling});
      for (uint32_t i = 0; i < map.size(); ++i) {
        const dvec3 p = texel_centre(i);
        const bool sheet = std::abs(p.x) < 1.0 && std::abs(p.z) < 1.0;
        const bool expected = masked ? sheet && p.x < 0.0 : sheet && !front_face_culling;
        EXPECT_NEAR(double(map[i]), expected ? depth_of(3.0) : 1.0, 1e-6) << i << (masked ? " masked" : " opaque");
      }
    }
  }
}

TEST(DepthPass, FrontFaceCullingKeepsTheFarSideOfMirroredAndPlainBoxes) {
  const mat4 mirrored = glm::scale(mat4(1.0f), vec3(-1, 1, 1)), rotated = glm::rotate(mat4(1.0f), k_pi / 2.0f, vec3(0, 1, 0));
  for (const mat4& transform : {mat4(1.0f), mirrored, rotated, mirrored * rotated}) {
    for (const bool double_sided : {false, true}) {
      for (const bool front_face_culling : {false, true}) {
        Scene scene = test::scene_with({test::box_part({-1, 1, -1}, {1, 2, 1})});
        scene.objects[0].world_from_object = transform;
        scene.materials[0].double_sided = double_sided;
        const auto map = depth_map(std::move(scene), {.front_face_culling = front_face_culling});
        const double expected = depth_of(front_face_culling ? 1.0 : 2.0);
        EXPECT_NEAR(double(map[k_size / 2 * k_size + k_size / 2]), expected, 1e-6)
            << "culling " << front_face_culling << ", double-sided " << double_sided << ", determinant "
            << glm::determinant(transform);
      }
    }
  }
}

TEST(DepthPass, CasterBeforeTheNearPlaneIsClampedOntoItOrLost) {
  if (!device().info().depth_clamp) GTEST_SKIP() << "the device clamps no depth";
  const Scene scene = test::scene_with({test::box_part({-1, 12, -1}, {1, 13, 1})});
  const size_t middle = k_size / 2 * k_size + k_size / 2;
  EXPECT_EQ(depth_map(scene, {.depth_clamp = true})[middle], 0.0f);
  EXPECT_EQ(depth_map(scene, {.depth_clamp = false})[middle], 1.0f);
}

}  // namespace
}  // namespace gnomon
