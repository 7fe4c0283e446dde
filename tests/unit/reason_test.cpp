// The reason in words: each cause from the facts that show it.
#include "lab/explain/reason.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

constexpr float k_range_m = 100.0f;
constexpr float k_texel_m = 0.1f;
constexpr float k_size = 1000.0f;

// A receiver in the middle of an orthographic map 100 m wide and deep, at depth 0.5; every texel sees it.
PickFacts lit_receiver() {
  PickFacts facts;
  facts.has_map = true;
  PickRecord& record = facts.record;
  record.seen = record.receives = record.casts = 1;
  record.count = 1;
  record.facing = 0.7f;
  record.answer = 1.0f;
  record.radius = 1.5f;
  PickedLayer& layer = record.layers[0];
  layer.weight = 1.0f;
  layer.texel_x = layer.texel_y = 500;
  layer.uv = (vec2(500.0f) + 0.5f) / k_size;
  layer.depth = layer.linear = layer.unbiased_depth = layer.unbiased_linear = 0.5f;
  layer.size = k_size;
  layer.texel_m = k_texel_m;
  layer.depth_range_m = k_range_m;
  layer.pixels_per_texel = 8.0f;
  layer.linear_numerator = vec4(0, 0, 1, 0);
  layer.linear_denominator = vec4(0, 0, 0, 1);
  layer.plane_move = 1.0f;
  std::fill(std::begin(layer.depths), std::end(layer.depths), 0.5f);
  facts.hard = facts.area = 1.0f;
  return facts;
}

void set_bias(PickFacts& facts, float metres) {
  PickedLayer& layer = facts.record.layers[0];
  layer.bias_linear = metres / k_range_m;
  layer.depth = layer.linear = 0.5f - layer.bias_linear;
}

void set_rise(PickFacts& facts, float metres_a_texel, bool followed) {
  PickedLayer& layer = facts.record.layers[0];
  layer.plane_gradient = layer.plane_linear_gradient = vec2(metres_a_texel / k_range_m * k_size, 0.0f);
  layer.follows_plane = followed;
  if (followed) layer.depth_gradient = layer.plane_gradient;
  for (int i = 0; i < 225; ++i) layer.depths[i] = 0.5f + static_cast<float>(i % 15 - 7) * metres_a_texel / k_range_m;
}

// dx, dy: texels from the point's.
float& depth_at(PickFacts& facts, int dx, int dy) { return facts.record.layers[0].depths[(7 + dy) * 15 + 7 + dx]; }

void expect(const PickFacts& facts, Cause cause, std::initializer_list<const char*> words) {
  const Reason reason = reason_of(facts);
  EXPECT_EQ(static_cast<int>(reason.cause), static_cast<int>(cause)) << reason.text;
  for (const char* word : words) EXPECT_NE(reason.text.find(word), std::string::npos) << reason.text << "\nlacks: " << word;
}

TEST(Reason, RightAnswersAreCalledSo) {
  PickFacts facts = lit_receiver();
  expect(facts, Cause::none, {"lit", "ray to the light's centre"});
  facts.record.answer = 0.0f;
  facts.hard = facts.area = 0.0f;
  std::fill(std::begin(facts.record.layers[0].depths), std::end(facts.record.layers[0].depths), 0.3f);
  expect(facts, Cause::none, {"in shadow", "a caster 20.00 m nearer"});
  facts.record.answer = 0.4f;
  facts.hard = 0.0f, facts.area = 0.42f;
  expect(facts, Cause::none, {"0.40", "real size"});
}

TEST(Reason, WithoutReferenceNothingIsWrong) {
  PickFacts facts = lit_receiver();
  facts.hard = facts.area = std::nullopt;
  expect(facts, Cause::none, {"not yet known"});
}

TEST(Reason, WhatIsNoReceiver) {
  PickFacts facts = lit_receiver();
  facts.record.receives = 0;
  expect(facts, Cause::no_receiver, {"beyond the light's range"});
  facts.record.facing = -0.3f;
  expect(facts, Cause::no_receiver, {"faces away", "-0.30"});
  facts.record.seen = 0;
  expect(facts, Cause::sky, {"sky"});
}

TEST(Reason, OutsideTheMap) {
  PickFacts facts = lit_receiver();
  facts.record.count = 0;
  facts.hard = facts.area = 0.0f;
  expect(facts, Cause::outside_map, {"false light of 1.00", "outside every layer"});
  facts.record.last_split = 40.0f;
  facts.record.view_depth = 52.3f;
  expect(facts, Cause::last_split, {"behind the last split", "40.00 m", "52.30 m"});
  facts.hard = facts.area = 1.0f;
  expect(facts, Cause::none, {"lit"});
}

TEST(Reason, AcneSaysWhatThePlaneSpansAndTheBiasCovers) {
  PickFacts facts = lit_receiver();
  set_rise(facts, 0.1f, false);
  set_bias(facts, 0.02f);
  facts.record.answer = 0.6f;
  // 1.5 texels of reach, rising a texel's width each: 1.5 texels; the bias is 0.2.
  expect(facts, Cause::acne, {"false shadow of 0.40", "acne", "spans 1.5 texels (15.0 cm)", "covers 0.2 texels (2.0 cm)"});
}

TEST(Reason, AcneWhereThePlaneIsFollowed) {
  PickFacts facts = lit_receiver();
  set_rise(facts, 0.0f, true);
  set_bias(facts, 0.01f);
  for (int dx = -1; dx <= 1; ++dx) depth_at(facts, dx, 0) = 0.5f - 0.03f / k_range_m;
  facts.record.answer = 0.6f;
  expect(facts, Cause::acne, {"leaves its plane", "covers 0.1 texels"});
  // A steep plane that is followed has no acne at all.
  PickFacts steep = lit_receiver();
  set_rise(steep, 0.5f, true);
  set_bias(steep, 0.01f);
  EXPECT_EQ(kernel_content(steep.record.layers[0], 5.0f).occluding, 0);
}

TEST(Reason, PeterPanning) {
  PickFacts facts = lit_receiver();
  set_bias(facts, 0.3f);
  for (float& depth : facts.record.layers[0].depths) depth = 0.5f - 0.2f / k_range_m;
  facts.hard = facts.area = 0.0f;
  expect(facts, Cause::peter_panning, {"false light of 1.00", "peter-panning", "3 texels (30.0 cm)", "gap of 20.0 cm"});
}

TEST(Reason, AFewTexelsThatTheBiasHidesAreNotTheCause) {
  PickFacts facts = lit_receiver();
  facts.record.radius = 3.5f;
  facts.record.answer = 0.5f;
  facts.hard = facts.area = 0.0f;
  set_bias(facts, 0.02f);
  for (int dx = -7; dx <= -1; ++dx) {
    for (int dy = -7; dy <= 7; ++dy) depth_at(facts, dx, dy) = 0.2f;
  }
  depth_at(facts, 1, 1) = 0.5f - 0.01f / k_range_m;
  expect(facts, Cause::filter_width, {"21 of 49 texels"});
}

TEST(Reason, LightBleedingOfFiltersThatBlur) {
  PickFacts facts = lit_receiver();
  facts.compares_depth = false;
  facts.record.answer = 0.4f;
  facts.hard = facts.area = 0.0f;
  for (int i = 0; i < 225; ++i) facts.record.layers[0].depths[i] = i % 2 ? 0.1f : 0.4f;
  expect(facts, Cause::light_bleeding,
         {"false light of 0.40", "light bleeding", "40.00 m nearer", "standard deviation", "0.40"});
}

TEST(Reason, ResolutionWhereTheTexelSeesACasterAndThePointDoesNot) {
  PickFacts facts = lit_receiver();
  facts.record.radius = 0.5f;
  facts.record.answer = 0.0f;
  depth_at(facts, 0, 0) = 0.47f;
  expect(facts, Cause::resolution, {"false shadow of 1.00", "resolution", "10.0 cm wide", "8 pixels", "3.00 m nearer"});
}

TEST(Reason, FilterWidth) {
  PickFacts facts = lit_receiver();
  facts.record.answer = 0.67f;
  for (int dy = -1; dy <= 1; ++dy) depth_at(facts, 1, dy) = 0.4f;
  expect(facts, Cause::filter_width, {"false shadow of 0.33", "filter width", "3 of 9 texels", "1.5 texels (15.0 cm)"});
  facts.hard = facts.area = 0.0f;
  expect(facts, Cause::filter_width, {"false light of 0.67", "filter width", "3 of 9 texels"});
}

TEST(Reason, PenumbraWiderThanTheFiltersLeastRadius) {
  PickFacts facts = lit_receiver();
  facts.record.answer = 0.5f;
  for (int dy = -7; dy <= 7; ++dy) depth_at(facts, 6, dy) = 0.2f;
  expect(facts, Cause::penumbra, {"penumbra", "1.5 texels"});
}

TEST(Reason, CasterThatNoTexelHolds) {
  PickFacts facts = lit_receiver();
  facts.hard = facts.area = 0.0f;
  expect(facts, Cause::missed_caster, {"no texel nearby", "thinner than a texel"});
  facts.front_face_culling = true;
  expect(facts, Cause::missed_caster, {"front faces are culled"});
  depth_at(facts, 5, 0) = 0.2f;
  expect(facts, Cause::resolution, {"1 texels near"});
}

TEST(Reason, HistoryComesFirst) {
  PickFacts facts = lit_receiver();
  facts.unsettled = 0.4f;
  facts.hard = facts.area = 0.0f;
  expect(facts, Cause::history, {"40 %", "temporal.history"});
}

TEST(Reason, TechniquesWithoutAMap) {
  PickFacts facts = lit_receiver();
  facts.has_map = false;
  facts.hard = 0.0f, facts.area = 0.55f;
  expect(facts, Cause::penumbra, {"light's size"});
}

TEST(Reason, BeyondTheMapsEdgeNothingIsStored) {
  PickFacts facts = lit_receiver();
  for (int dx = 1; dx <= 7; ++dx) {
    for (int dy = -7; dy <= 7; ++dy) depth_at(facts, dx, dy) = k_pick_outside;
  }
  const KernelContent content = kernel_content(facts.record.layers[0], 1.5f);
  EXPECT_EQ(content.texels, 9);
  EXPECT_EQ(content.occluding, 0);
}

TEST(Reason, LengthsInTheirUnit) {
  EXPECT_EQ(length_text(12.345f), "12.35 m");
  EXPECT_EQ(length_text(0.0321f), "3.2 cm");
  EXPECT_EQ(length_text(0.0004f), "0.4 mm");
}

}  // namespace
}  // namespace gnomon
