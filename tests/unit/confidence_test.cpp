// The 95 % interval of the reference: of independent samples with a known truth it holds nineteen times in twenty, and misses
// once.
#include "reference/cpu/confidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace gnomon {
namespace {

struct Sampling {
  int pixels, points_of_pixel, samples;  // points of a pixel share their random numbers
};

// Share of the runs whose interval around the mean holds the truth.
double coverage(const Sampling& sampling) {
  constexpr int k_runs = 4000;
  std::mt19937 random(17);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  int held = 0;
  for (int run = 0; run < k_runs; ++run) {
    std::vector<SurfacePoint> points;
    std::vector<float> variance;
    double truth = 0.0, mean = 0.0;
    for (int pixel = 0; pixel < sampling.pixels; ++pixel) {
      const float visible = 0.2f + 0.6f * static_cast<float>(pixel) / static_cast<float>(sampling.pixels);
      int arrived = 0;
      for (int i = 0; i < sampling.samples; ++i) arrived += uniform(random) < visible;
      const float found = static_cast<float>(arrived) / static_cast<float>(sampling.samples);
      for (int i = 0; i < sampling.points_of_pixel; ++i) {
        points.push_back({vec3(0.0f), 0, vec3(0, 1, 0), static_cast<uint32_t>(pixel)});
        variance.push_back(visibility_variance(found, sampling.samples));
        truth += static_cast<double>(visible), mean += static_cast<double>(found);
      }
    }
    const auto n = static_cast<double>(points.size());
    const double width = mean_confidence(points, variance, std::vector<uint8_t>(points.size(), 1));
    held += std::abs(mean - truth) / n <= width;
  }
  return static_cast<double>(held) / k_runs;
}

TEST(Confidence, HoldsNineteenTimesInTwentyAndMissesOnce) {
  for (const Sampling& sampling : {Sampling{64, 1, 16}, Sampling{64, 4, 16}, Sampling{256, 1, 4}, Sampling{32, 2, 64}}) {
    const double held = coverage(sampling);
    EXPECT_GT(held, 0.93) << sampling.pixels << " pixels of " << sampling.points_of_pixel;
    EXPECT_LT(held, 0.97) << sampling.pixels << " pixels of " << sampling.points_of_pixel;
  }
}

TEST(Confidence, CountsReceiversAlone) {
  std::vector<SurfacePoint> points;
  for (uint32_t pixel = 0; pixel < 4; ++pixel) points.push_back({vec3(0.0f), 0, vec3(0, 1, 0), pixel});
  const std::vector<float> variance = {0.04f, 0.0f, 0.09f, 0.0f};
  EXPECT_NEAR(mean_confidence(points, variance, std::vector<uint8_t>{1, 0, 1, 0}), 1.96 * std::sqrt(0.13) / 2.0, 1e-6);
  EXPECT_EQ(mean_confidence(points, variance, std::vector<uint8_t>{0, 0, 0, 0}), 0.0);
}

TEST(Confidence, VarianceOfAPoint) {
  EXPECT_FLOAT_EQ(visibility_variance(0.25f, 4), 0.0625f) << "unbiased: n - 1";
  EXPECT_EQ(visibility_variance(1.0f, 64), 0.0f);
  EXPECT_EQ(visibility_variance(1.0f, 1), 0.25f);
}

}  // namespace
}  // namespace gnomon
