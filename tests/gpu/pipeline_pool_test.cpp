// Pipelines that nobody holds are taken again by whoever needs the same, and by nobody else.
#include "gpu/pipeline.h"
#include "gpu/shader.h"
#include "support/device_tests.h"

namespace gnomon {
namespace {

using test::device;

constexpr const char* k_shader = "frame/surface/surface_pack.comp";

TEST(PipelinePool, WhatNobodyHoldsIsTakenAgain) {
  const VkPipeline first = make_compute_pipeline(device(), k_shader, {1}).handle();
  const Pipeline again = make_compute_pipeline(device(), k_shader, {1});
  EXPECT_EQ(again.handle(), first);
  EXPECT_NE(make_compute_pipeline(device(), k_shader, {1}).handle(), first) << "one that is held is not shared";
}

TEST(PipelinePool, AllThatDecidesIsCompared) {
  // Known to the pool: one of each.
  const VkPipeline one = make_compute_pipeline(device(), k_shader, {1}).handle();
  EXPECT_NE(make_compute_pipeline(device(), k_shader, {4}).handle(), one);
  EXPECT_NE(make_compute_pipeline(device(), "frame/surface/surface_points.comp", {1}).handle(), one);

  GraphicsPipelineInfo info;
  info.vertex = "frame/casters/draw/caster_per_layer_opaque.vert";
  const VkPipeline plain = make_graphics_pipeline(device(), info).handle();
  GraphicsPipelineInfo equal = info, greater = info, clamped = info;
  equal.depth_compare = VK_COMPARE_OP_EQUAL;
  clamped.depth_clamp = true;
  EXPECT_EQ(make_graphics_pipeline(device(), greater).handle(), plain);
  EXPECT_NE(make_graphics_pipeline(device(), equal).handle(), plain);
  EXPECT_NE(make_graphics_pipeline(device(), clamped).handle(), plain);
}

// An edited shader is another one, although its name is the same; without the edit it is the old one again.
TEST(PipelinePool, EditedShadersAreOthers) {
  const VkPipeline built_in = make_compute_pipeline(device(), k_shader, {1}).handle();
  std::vector<uint32_t> words = find_shader(k_shader);
  ASSERT_GT(words.size(), 3u);
  words[2] += 1;  // the generator's number, which means nothing to a driver
  set_replaced_shaders({{k_shader, words}});
  const VkPipeline edited = make_compute_pipeline(device(), k_shader, {1}).handle();
  set_replaced_shaders({});
  EXPECT_NE(edited, built_in);
  EXPECT_EQ(make_compute_pipeline(device(), k_shader, {1}).handle(), built_in);
}

TEST(PipelinePool, TheOldestGoWhenThereAreTooMany) {
  PipelinePool pool(VK_NULL_HANDLE);
  const auto number = [](size_t i) { return reinterpret_cast<VkPipeline>(i + 1); };
  size_t i = 0;
  VkPipeline gone = VK_NULL_HANDLE;
  for (; i < 100000 && !gone; ++i) gone = pool.keep(fmt::format("recipe {}", i), number(i));
  EXPECT_EQ(gone, number(0));
  EXPECT_EQ(pool.take("recipe 0"), VK_NULL_HANDLE);
  EXPECT_EQ(pool.keep("", number(i)), number(i)) << "what cannot be told apart is not kept";
  EXPECT_EQ(pool.take(""), VK_NULL_HANDLE);
  for (size_t k = 1; k < i; ++k) EXPECT_EQ(pool.take(fmt::format("recipe {}", k)), number(k));
}

}  // namespace
}  // namespace gnomon
