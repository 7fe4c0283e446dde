// Order statistics on hand-computed samples.
#include "base/statistics.h"

#include <gtest/gtest.h>

#include <vector>

namespace gnomon {
namespace {

Summary of(std::vector<double> samples) { return summarise(samples); }

TEST(Statistics, OneSample) {
  const Summary summary = of({3.5});
  EXPECT_EQ(summary.median, 3.5);
  EXPECT_EQ(summary.p95, 3.5);
  EXPECT_EQ(summary.mad, 0.0);
}

TEST(Statistics, MedianOfEvenAndOddCounts) {
  EXPECT_EQ(of({5, 1, 3}).median, 3.0);
  EXPECT_EQ(of({4, 1, 3, 2}).median, 2.5);
}

TEST(Statistics, MadIsTheMedianOfDeviations) {
  EXPECT_EQ(of({1, 1, 2, 2, 4, 6, 9}).mad, 1.0);
  EXPECT_EQ(of({1, 2, 3, 1000}).mad, 1.0) << "one outlier does not move it";
}

TEST(Statistics, P95IsTheNearestRank) {
  std::vector<double> samples;
  for (int i = 100; i >= 1; --i) samples.push_back(i);
  EXPECT_EQ(of(samples).p95, 95.0);
  samples.resize(20);  // 81 to 100
  EXPECT_EQ(of(samples).p95, 99.0);
  EXPECT_EQ(of({1, 2}).p95, 2.0);
}

// Where mean, median, largest and standard deviation are far apart, in any order.
TEST(Statistics, OneSlowFrameMovesNeitherMedianNorMad) {
  for (const auto& samples : {std::vector<double>{100, 1, 2, 3, 5}, std::vector<double>{1, 2, 3, 5, 100}}) {
    const Summary summary = of(samples);  // mean 22.2, deviations 2 1 0 2 97 from the median
    EXPECT_EQ(summary.median, 3.0);
    EXPECT_EQ(summary.mad, 2.0);
    EXPECT_EQ(summary.p95, 100.0);
  }
  const Summary even = of({8, 1, 40, 2});  // mean 12.75, deviations 4 3 3 35 from 5
  EXPECT_EQ(even.median, 5.0);
  EXPECT_EQ(even.mad, 3.5);
}

}  // namespace
}  // namespace gnomon
