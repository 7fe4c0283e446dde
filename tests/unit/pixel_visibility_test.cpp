// The truth of pixels: which points within a pixel count for which of its samples.
#include "reference/cpu/pixel_visibility.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace gnomon {
namespace {

SurfacePoint point(const vec3& at, const vec3& normal = vec3(0, 1, 0), uint32_t pixel = 0) { return {at, 0, normal, pixel}; }
SurfaceSample sample(uint32_t item, uint32_t primitive, const vec3& normal = vec3(0, 1, 0)) {
  return {10.0f, normal, item, primitive};
}

ReferenceResult answer(float visibility, uint8_t receiver = 1) { return {{visibility}, {receiver}, 0.0}; }

TEST(PixelVisibility, PlacesAreTheMiddlesOfSquares) {
  const auto places = subpixel_places(16);
  ASSERT_EQ(places.size(), 16u);
  vec2 sum(0.0f);
  for (const vec2& place : places) sum += place;
  EXPECT_LT(glm::length(sum), 1e-6f);
  EXPECT_EQ(places.front(), vec2(-0.375f, -0.375f)) << "the first pixel of a picture of four times the size";
  EXPECT_EQ(places[1], vec2(-0.125f, -0.375f));
  EXPECT_EQ(subpixel_places(1).front(), vec2(0.0f));
}

TEST(PixelVisibility, WhatIsNoSquareIsRefusedWithItsNeighbours) {
  for (const auto& [count, below, above] : {std::tuple(15, "9", "16"), std::tuple(2, "1", "4"), std::tuple(0, "1", "4")}) {
    try {
      subpixel_places(count);
      ADD_FAILURE() << count;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::usage);
      EXPECT_NE(std::string(error.what()).find(fmt::format("valid: {} or {}", below, above)), std::string::npos)
          << error.what();
    }
  }
}

TEST(PixelVisibility, IsTheMeanOverThePointsOnThatSurfaceAlone) {
  PixelAverage average({point({0, 0, 0})}, {sample(3, 0)}, {1}, 1);
  const auto add = [&](const SurfacePoint& p, const SurfaceSample& s, const ReferenceResult& a) {
    average.add(std::vector{p}, std::vector{s}, a, 1);
  };
  add(point({0.1f, 0, 0}), sample(3, 0), answer(1.0f));
  add(point({0.1f, 0, 0.1f}), sample(3, 7), answer(0.0f));  // a neighbour in its plane
  add(point({0, 0, 0.1f}), sample(3, 0), answer(0.5f));
  add(point({0.1f, 0, 0}), sample(4, 0), answer(0.0f));                                    // another item
  add(point({0.1f, -0.1f, 0}), sample(3, 8), answer(0.0f));                                // a step below
  add(point({0.1f, 0, 0}, {0.6f, 0.8f, 0}), sample(3, 9, {0.6f, 0.8f, 0}), answer(0.0f));  // beyond a crease
  add(point({0.1f, 0, 0}), sample(k_no_item, 0), answer(0.0f, 0));                         // the sky
  add(point({0.1f, 0, 0}), sample(3, 0), answer(0.0f, 0));                                 // faces away from the light
  const PixelVisibility pixel = average.finish();
  EXPECT_EQ(pixel.result.receiver, std::vector<uint8_t>{1});
  EXPECT_FLOAT_EQ(pixel.result.visibility[0], 0.5f);
  EXPECT_EQ(pixel.uncovered, 0.0);
}

// A quarter of the points, at least: three of sixteen say nothing of a pixel.
TEST(PixelVisibility, SurfacesOfTooFewPointsAreCountedAndNotJudged) {
  for (const int on : {3, 4}) {
    // The second sample of the pixel faces away from the light: neither judged nor uncovered.
    PixelAverage average({point({0, 0, 0}), point({0, 0, 0})}, {sample(1, 0), sample(2, 0)}, {1, 0}, 2);
    for (int i = 0; i < 16; ++i)
      average.add(std::vector{point({0, 0, 0})}, std::vector{sample(i < on ? 1 : 2, 0)}, answer(1.0f), 1);
    const PixelVisibility pixel = average.finish();
    EXPECT_EQ(pixel.result.receiver, (std::vector<uint8_t>{static_cast<uint8_t>(on == 4), 0}));
    EXPECT_EQ(pixel.uncovered, on == 4 ? 0.0 : 1.0);
  }
}

// The interval shrinks with the points; a pixel of one answer throughout has none.
TEST(PixelVisibility, ConfidenceIsOfThePoints) {
  const auto confidence = [](int points, bool edge) {
    PixelAverage average({point({0, 0, 0})}, {sample(1, 0)}, {1}, 1);
    for (int i = 0; i < points; ++i)
      average.add(std::vector{point({0, 0, 0})}, std::vector{sample(1, 0)}, answer(edge && i % 2 ? 0.0f : 1.0f), 1);
    return average.finish().result.confidence;
  };
  EXPECT_EQ(confidence(16, false), 0.0);
  EXPECT_NEAR(confidence(16, true), 1.96 * std::sqrt(0.25 / 15.0), 1e-6);
  EXPECT_LT(confidence(64, true), 0.55 * confidence(16, true));
}

}  // namespace
}  // namespace gnomon
