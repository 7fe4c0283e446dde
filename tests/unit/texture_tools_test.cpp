// Which alpha channels are cut-outs: soft edges are, ramps and highlights are not.
#include "scene/texture_tools.h"

#include <gtest/gtest.h>

#include <functional>

namespace gnomon {
namespace {

AlphaShares shares_of(int size, const std::function<int(int, int)>& alpha) {
  Image8 image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) image.at(x, y)[3] = static_cast<uint8_t>(alpha(x, y));
  }
  return alpha_shares(image);
}

// A net of wires: `solid` texels with `soft` half-transparent ones at either side, every `period`.
AlphaShares net(int period, int solid, int soft) {
  const auto wire = [=](int t) {
    const int at = (t + period / 2) % period;  // no wire at the border
    return at < solid + 2 * soft ? (at < soft || at >= soft + solid ? 128 : 255) : 0;
  };
  return shares_of(64, [&](int x, int y) { return std::max(wire(x), wire(y)); });
}

// A column of that many clear, middling and solid texels, in this order.
AlphaShares bands(int clear, int between, int solid) {
  return shares_of(clear + between + solid, [=](int x, int) { return x < clear ? 0 : x < clear + between ? 128 : 255; });
}

TEST(AlphaShares, AreCounted) {
  const AlphaShares shares = shares_of(16, [](int x, int) { return 17 * x; });
  EXPECT_DOUBLE_EQ(shares.clear, 2.0 / 16.0);
  EXPECT_DOUBLE_EQ(shares.solid, 2.0 / 16.0);
  EXPECT_DOUBLE_EQ(shares.between, 12.0 / 16.0);
  EXPECT_DOUBLE_EQ(shares.edges, 0.0);
  EXPECT_DOUBLE_EQ(shares.holes, 8.0 / 16.0);
  EXPECT_DOUBLE_EQ(bands(10, 3, 10).edges, 1.0 / 23.0) << "the middle one alone has both ends within two texels";
  EXPECT_DOUBLE_EQ(bands(10, 2, 10).edges, 2.0 / 22.0);
}

TEST(CutOut, NetsWithSoftEdgesAre) {
  const AlphaShares thin = net(16, 1, 1);
  EXPECT_GT(thin.between, 1.5 * thin.solid) << "more soft texels than solid ones";
  EXPECT_DOUBLE_EQ(thin.edges, thin.between);
  EXPECT_TRUE(is_cut_out(thin));
  EXPECT_TRUE(is_cut_out(net(8, 1, 1)));
  EXPECT_TRUE(is_cut_out(net(16, 6, 1)));
}

TEST(CutOut, EnlargedNetsAreToo) {
  const AlphaShares large = net(64, 4, 4);  // as net(16, 1, 1), four times as large: no edge is within two texels of both ends
  EXPECT_DOUBLE_EQ(large.between - large.edges, large.between);
  EXPECT_TRUE(is_cut_out(large)) << large.between << " between, " << large.solid << " solid";
}

TEST(CutOut, WhatLiesBetweenWithoutBeingEdgesIsHeldAgainstTheScarcerEnd) {
  EXPECT_TRUE(is_cut_out(bands(60, 15, 10)));
  EXPECT_TRUE(is_cut_out(bands(10, 15, 60)));
  EXPECT_FALSE(is_cut_out(bands(60, 26, 10)));
  EXPECT_FALSE(is_cut_out(bands(10, 26, 60)));
}

TEST(CutOut, HighlightsOfAGlossAreNot) {
  const auto spot = [](int x, int y) {
    const double distance = std::hypot(x % 32 - 16, y % 32 - 16);
    return std::clamp(static_cast<int>(255.0 - 20.0 * distance), 0, 255);
  };
  const AlphaShares shares = shares_of(64, spot);
  EXPECT_GT(shares.solid, 0.0);
  EXPECT_LT(shares.between, 0.4);
  EXPECT_FALSE(is_cut_out(shares));
}

// A ramp so steep that most of it counts as an edge is still a ramp: most texels must be clear or solid.
TEST(CutOut, MostTexelsAreClearOrSolid) {
  EXPECT_FALSE(is_cut_out(shares_of(4, [](int x, int) { return 85 * x; })));
  const AlphaShares fence = net(5, 1, 1);
  EXPECT_LT(fence.between, 0.5);
  EXPECT_TRUE(is_cut_out(fence));
}

TEST(CutOut, RampsAndWhatLacksAnEndAreNot) {
  for (const int size : {8, 16, 256})
    EXPECT_FALSE(is_cut_out(shares_of(size, [=](int x, int) { return 255 * x / (size - 1); }))) << size;
  EXPECT_FALSE(is_cut_out(bands(30, 5, 0)));
  EXPECT_FALSE(is_cut_out(bands(0, 5, 30)));
}

}  // namespace
}  // namespace gnomon
