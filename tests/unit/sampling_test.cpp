// The sequence, its scrambling and the maps from the unit square.
#include "base/glsl/sampling.glsl"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace gnomon {
namespace {

// Whether the 2^m points from `first` put exactly one into each elementary interval of area 2^-m, for every shape of it.
bool is_net(uint32_t first, uint32_t m, uint32_t scramble_x, uint32_t scramble_y) {
  const uint32_t count = 1u << m;
  for (uint32_t a = 0; a <= m; ++a) {
    const uint32_t columns = 1u << a, rows = 1u << (m - a);
    std::vector<bool> taken(count);
    for (uint32_t i = 0; i < count; ++i) {
      const vec2 p = scrambled_02_sequence(first + i, scramble_x, scramble_y);
      const auto x = static_cast<uint32_t>(p.x * static_cast<float>(columns)),
                 y = static_cast<uint32_t>(p.y * static_cast<float>(rows));
      if (x >= columns || y >= rows || taken[y * columns + x]) return false;
      taken[y * columns + x] = true;
    }
  }
  return true;
}

TEST(Sampling, EveryBlockOfTheSequenceIsStratified) {
  for (uint32_t m = 0; m <= 8; ++m) {
    for (uint32_t block = 0; block < 9; ++block) EXPECT_TRUE(is_net(block << m, m, 0, 0)) << block << " of 2^" << m;
  }
}

TEST(Sampling, ScramblingKeepsTheStratification) {
  for (uint32_t seed = 1; seed < 40; ++seed) {
    const uint32_t x = hash_uint(seed), y = hash_uint(x);
    EXPECT_TRUE(is_net(0, 6, x, y) && is_net(192, 6, x, y)) << seed;
  }
}

TEST(Sampling, KnownStartOfTheSequence) {
  EXPECT_EQ(scrambled_02_sequence(0, 0, 0), vec2(0.0f));
  EXPECT_EQ(scrambled_02_sequence(1, 0, 0), vec2(0.5f));
  EXPECT_EQ(scrambled_02_sequence(2, 0, 0), vec2(0.25f, 0.75f));
  EXPECT_EQ(scrambled_02_sequence(3, 0, 0), vec2(0.75f, 0.25f));
}

TEST(Sampling, UnitFloatStaysBelowOne) {
  EXPECT_EQ(unit_float(0u), 0.0f);
  EXPECT_LT(unit_float(0xffffffffu), 1.0f);
  EXPECT_EQ(unit_float(0x80000000u), 0.5f);
}

TEST(Sampling, ReverseBits) {
  EXPECT_EQ(reverse_bits(1u), 0x80000000u);
  EXPECT_EQ(reverse_bits(0x12345678u), 0x1e6a2c48u);
}

TEST(Sampling, HashFlipsHalfOfTheBits) {
  double flipped = 0.0;
  for (uint32_t i = 0; i < 1000; ++i) {
    for (uint32_t bit = 0; bit < 32; ++bit) flipped += std::popcount(hash_uint(i) ^ hash_uint(i ^ (1u << bit)));
  }
  EXPECT_NEAR(flipped / 32000.0, 16.0, 0.25);
  std::set<uint32_t> values;
  for (uint32_t i = 0; i < 10000; ++i) values.insert(hash_uint(i));
  EXPECT_EQ(values.size(), 10000u);  // a permutation
}

// Share of a fine regular grid of the square that lands where `inside` holds.
template <class Inside>
double share(Inside inside) {
  constexpr int k_side = 512;
  int count = 0;
  for (int y = 0; y < k_side; ++y) {
    for (int x = 0; x < k_side; ++x) {
      count += inside(concentric_disc((vec2(x, y) + 0.5f) / static_cast<float>(k_side))) ? 1 : 0;
    }
  }
  return count / static_cast<double>(k_side * k_side);
}

TEST(Sampling, DiscMapIsUniformInArea) {
  EXPECT_EQ(share([](vec2 p) { return glm::length(p) > 1.0f + 1.0e-6f; }), 0.0);
  for (const float radius : {0.25f, 0.5f, 0.9f}) {
    EXPECT_NEAR(share([&](vec2 p) { return glm::length(p) < radius; }), static_cast<double>(radius * radius), 0.004);
  }
  for (int sector = -8; sector < 8; ++sector) {
    const float from = k_pi / 8.0f * static_cast<float>(sector), to = from + k_pi / 8.0f;
    const auto inside = [&](vec2 p) { return std::atan2(p.y, p.x) >= from && std::atan2(p.y, p.x) < to; };
    EXPECT_NEAR(share(inside), 1.0 / 16.0, 0.002) << sector;
  }
  EXPECT_NEAR(share([](vec2 p) { return p.x > 0.5f; }), (k_pi / 3.0 - std::sqrt(3.0) / 4.0) / k_pi, 0.003);
}

TEST(Sampling, DiscMapTakesCentreToCentreAndBorderToBorder) {
  EXPECT_EQ(concentric_disc(vec2(0.5f)), vec2(0.0f));
  for (const vec2 square : {vec2(0, 0.3f), vec2(1, 0.8f), vec2(0.1f, 0), vec2(0.6f, 1), vec2(0), vec2(1)}) {
    EXPECT_NEAR(glm::length(concentric_disc(square)), 1.0f, 1.0e-6f);
  }
}

TEST(Sampling, RayOriginsAreNearAndOnTheRightSide) {
  for (const float distance : {0.1f, 1.0f, 10.0f, 100.0f}) {
    const vec3 normal = glm::normalize(vec3(1, 2, 3)), position = 0.2f * distance * vec3(1, -1, 1);
    const float offset = glm::dot(ray_origin(position, normal, distance, vec2(0, 1)) - position, normal);
    EXPECT_GT(offset, 0.5e-5f * distance);
    EXPECT_LT(offset, 1.0e-5f * std::max(distance, 1.0f)) << "0.1 mm at 10 m";
    EXPECT_GT(glm::dot(ray_origin(position, normal, distance, vec2(100, 1)) - position, normal), offset);
  }
}

}  // namespace
}  // namespace gnomon
