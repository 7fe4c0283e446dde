// Culling and layering of casters: every way to draw a map gives the same bits, and culling draws less.
#include "frame/casters/caster_draws.h"

#include <cmath>

#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;

constexpr uint32_t k_size = 128, k_layers = 4;

// Four views of growing width from above, and a fifth that is not in use.
Buffer views(const Box& box) {
  Buffer buffer(device(), "views", (k_layers + 1) * sizeof(LightView), BufferMemory::upload);
  for (uint32_t i = 0; i <= k_layers; ++i) {
    const float half = box.radius() * std::exp2(static_cast<float>(i)) / 16.0f;
    const vec3 centre = box.centre();
    mat4 clip(0.0f);
    clip[0][0] = 1.0f / half, clip[2][1] = 1.0f / half, clip[1][2] = -1.0f / (2.0f * box.radius());
    clip[3] = vec4(-centre.x / half, -centre.z / half, 0.5f + centre.y / (2.0f * box.radius()), 1.0f);
    buffer.mapped_as<LightView>()[i] = {clip, k_view_projective, 0.0f, 1.0f, i < k_layers ? 1u : 0u};
  }
  buffer.flush();
  return buffer;
}

struct Drawn {
  std::vector<float> depths;
  uint64_t triangles = 0;
};

Drawn draw(test::View& view, LayeringPath path, CasterCulling culling) {
  constexpr uint32_t layers = k_layers + 1;
  ImageInfo info;
  info.name = "map";
  info.width = info.height = k_size, info.layers = layers;
  info.format = VK_FORMAT_D32_SFLOAT;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const Image map(device(), info);
  const Buffer light = views(view.gpu_scene().caster_bounds()),
               result(device(), "depths", size_t{layers} * k_size * k_size * 4);
  CasterDraws draws(device(), view.gpu_scene(), "test", {.path = path, .layers = layers});
  const FrameResult frame = test::run_passes([&](Recorder& recorder) {
    draws.record(recorder, "test", {&light, 0, sizeof(LightView), layers}, culling, false, map);
    recorder.pass("copy", PassStage::other, {{map, Use::copy_read}, {result, Use::copy_write}}, [&](Commands& commands) {
      VkBufferImageCopy region = {};
      region.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, layers};
      region.imageExtent = {k_size, k_size, 1};
      vkCmdCopyImageToBuffer(commands.handle(), map.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, result.handle(), 1,
                             &region);
    });
  });
  Drawn drawn;
  drawn.depths = read_back_as<float>(device(), result, size_t{layers} * k_size * k_size);
  for (const PassResult& pass : frame.passes) drawn.triangles += pass.triangles;
  return drawn;
}

TEST(CasterDraws, EveryPathAndCullingDrawsTheSameBits) {
  test::View view(load_scene("courtyard"));
  const Drawn expected = draw(view, LayeringPath::per_layer, CasterCulling::none);
  size_t covered = 0;
  for (const float depth : expected.depths) covered += depth < 1.0f;
  ASSERT_GT(covered, expected.depths.size() / 4);
  for (size_t i = size_t{k_layers} * k_size * k_size; i < expected.depths.size(); ++i)
    ASSERT_EQ(expected.depths[i], 1.0f) << "a layer that is not in use";
  for (const auto path :
       {LayeringPath::per_layer, LayeringPath::vertex_layer, LayeringPath::geometry, LayeringPath::multiview}) {
    if (const std::string missing = layering_path_missing(device().info(), path); !missing.empty()) {
      fmt::print("{} is not tested: the device lacks {}\n", layering_path_name(path), missing);
      continue;
    }
    for (const auto culling : {CasterCulling::none, CasterCulling::objects, CasterCulling::clusters}) {
      const Drawn found = draw(view, path, culling);
      EXPECT_EQ(found.depths, expected.depths) << layering_path_name(path) << ", culling " << static_cast<int>(culling);
    }
  }
}

// A caster before a view's near plane still shadows what lies in the view: its bounds are swept along the light. Behind the far
// plane there is nothing to shadow, and beside the view neither.
TEST(CasterDraws, CullingSweepsBoundsAlongTheLight) {
  if (!device().info().pipeline_statistics) GTEST_SKIP() << "the device counts no triangles";
  struct Case {
    const char* name;
    vec3 at;
    bool drawn;
  };
  // The view: |x| and |z| below 2, y from 2 (near) down to -2 (far).
  mat4 clip(0.0f);
  clip[0][0] = 0.5f, clip[2][1] = 0.5f, clip[1][2] = -0.25f;
  clip[3] = vec4(0, 0, 0.5f, 1);
  for (const Case& c : {Case{"within", {0, 0, 0}, true}, Case{"just before the near plane", {0, 3, 0}, true},
                        Case{"far before the near plane", {1, 500, -1}, true}, Case{"behind the far plane", {0, -4, 0}, false},
                        Case{"beside", {4, 0, 0}, false}, Case{"before the near plane and beside", {0, 9, -4}, false}}) {
    Scene scene = test::scene_with({test::box_part(c.at - vec3(0.5f), c.at + vec3(0.5f))});
    scene.cameras.push_back(look_at("any", {0, 1, 5}, {0, 0, 0}, 60.0));
    scene.lights.push_back(test::make_sun({0, -1, 0}));
    test::View view(std::move(scene));
    Buffer light(device(), "views", sizeof(LightView), BufferMemory::upload);
    light.mapped_as<LightView>()[0] = {clip, k_view_projective, 0.0f, 1.0f, 1u};
    light.flush();
    ImageInfo info;
    info.name = "map";
    info.width = info.height = 16;
    info.format = VK_FORMAT_D32_SFLOAT;
    info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    const Image map(device(), info);
    for (const CasterCulling culling : {CasterCulling::objects, CasterCulling::clusters}) {
      CasterDraws draws(device(), view.gpu_scene(), "test", {.path = LayeringPath::per_layer, .layers = 1});
      uint64_t triangles = 0;
      const FrameResult frame = test::run_passes([&](Recorder& recorder) {
        draws.record(recorder, "test", {&light, 0, sizeof(LightView), 1}, culling, false, map);
      });
      for (const PassResult& pass : frame.passes) triangles += pass.triangles;
      EXPECT_EQ(triangles > 0, c.drawn) << c.name << ", culling " << static_cast<int>(culling);
    }
  }
}

TEST(CasterDraws, CullingLeavesTrianglesOut) {
  if (!device().info().pipeline_statistics) GTEST_SKIP() << "the device counts no triangles";
  test::View view(load_scene("courtyard"));
  const uint64_t none = draw(view, LayeringPath::per_layer, CasterCulling::none).triangles;
  const uint64_t objects = draw(view, LayeringPath::per_layer, CasterCulling::objects).triangles;
  const uint64_t clusters = draw(view, LayeringPath::per_layer, CasterCulling::clusters).triangles;
  fmt::print("triangles: {} without culling, {} by objects, {} by clusters\n", none, objects, clusters);
  EXPECT_EQ(none, k_layers * view.gpu_scene().caster_triangles());
  EXPECT_LT(objects, none);
  EXPECT_LT(clusters, objects);
}

}  // namespace
}  // namespace gnomon
