// Pipelines that nobody holds are taken again by whoever needs the same, and by nobody else.
#include <functional>

#include "frame/casters/caster_draws.h"
#include "gpu/pipeline_target.h"
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
}

// The pipeline of `info` and target against one that differs in a single thing: equal recipes would hand out the wrong one.
class Compared {
 public:
  explicit Compared(GraphicsPipelineInfo info, PipelineTarget target = {})
      : info_(std::move(info)), target_(target), handle_(make_graphics_pipeline(device(), info_, target_).handle()) {
    EXPECT_EQ(make_graphics_pipeline(device(), info_, target_).handle(), handle_);
  }
  void differs(const char* in, const std::function<void(GraphicsPipelineInfo&, PipelineTarget&)>& change) const {
    GraphicsPipelineInfo info = info_;
    PipelineTarget target = target_;
    change(info, target);
    EXPECT_NE(make_graphics_pipeline(device(), info, target).handle(), handle_) << in;
  }

 private:
  GraphicsPipelineInfo info_;
  PipelineTarget target_;
  VkPipeline handle_;
};

TEST(PipelinePool, OfDepthAloneAllThatDecidesIsCompared) {
  GraphicsPipelineInfo info;
  info.vertex = "frame/casters/draw/caster_per_layer_masked.vert";
  const Compared masked(info);
  masked.differs("vertex", [](auto& i, auto&) { i.vertex = "frame/casters/draw/caster_per_layer_opaque.vert"; });
  masked.differs("fragment", [](auto& i, auto&) { i.fragment = "frame/casters/draw/caster_masked.frag"; });
  masked.differs("depth format", [](auto& i, auto&) { i.depth_format = VK_FORMAT_D16_UNORM; });
  masked.differs("depth compare", [](auto& i, auto&) { i.depth_compare = VK_COMPARE_OP_EQUAL; });
  masked.differs("depth clamp", [](auto& i, auto&) { i.depth_clamp = true; });
  masked.differs("constants", [](auto& i, auto&) { i.constants = {1}; });
  if (device().info().sample_counts.size() > 1)
    masked.differs("samples", [](auto& i, auto&) { i.samples = static_cast<uint32_t>(device().info().sample_counts[1]); });
  if (layering_path_missing(device().info(), LayeringPath::multiview).empty()) {
    info.vertex = "frame/casters/draw/caster_multiview_opaque.vert";
    info.view_mask = 1;
    Compared(info).differs("view mask", [](auto& i, auto&) { i.view_mask = 3; });
  }
  if (layering_path_missing(device().info(), LayeringPath::geometry).empty()) {
    info = {};
    info.vertex = "frame/casters/draw/caster_geometry_opaque.vert";
    Compared(info).differs("geometry", [](auto& i, auto&) { i.geometry = "frame/casters/draw/caster_opaque.geom"; });
  }
}

TEST(PipelinePool, OfFragmentsAllThatDecidesIsCompared) {
  GraphicsPipelineInfo info;
  info.vertex = "frame/surface/surface.vert";
  info.fragment = "frame/shading/overdraw.frag";
  info.colour_formats = {VK_FORMAT_R16_SFLOAT};
  const Compared written(info);
  written.differs("a colour's format", [](auto& i, auto&) { i.colour_formats = {VK_FORMAT_R32_SFLOAT}; });
  written.differs("adds", [](auto&, auto& target) { target.adds = true; });
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
