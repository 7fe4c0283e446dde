// The CPU reference with area lights: closed forms within its own confidence interval.
#include <gtest/gtest.h>

#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"

namespace gnomon {
namespace {

using namespace test;

const vec3 k_eye(0, 10, 0);

// Share of the unit disc where x > -t.
double disc_beyond(double t) {
  const double c = std::clamp(t, -1.0, 1.0);
  return 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / glm::pi<double>();
}

// Covers x < 0 at height 2.
Scene slab_scene() {
  Scene scene = empty_scene();
  add(scene, quad({-50, 2, 0}, {0, 0, 50}, {50, 0, 0}));
  return scene;
}

std::vector<SurfacePoint> column_of_points(float x, uint32_t count) {
  std::vector<SurfacePoint> points;
  for (uint32_t i = 0; i < count; ++i) points.push_back(floor_point(x, 0.01f * static_cast<float>(i), i));
  return points;
}

double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

TEST(EmbreeArea, PenumbraOfASlabIsACircularSegment) {
  const Scene scene = slab_scene();
  const EmbreeReference reference(scene);
  const Light light = sun({0, -1, 0}, 0.2f);
  const double reach = 2.0 * std::tan(0.1);  // of the penumbra to either side, metres
  for (const double t : {-1.01, -0.9, -0.5, -0.1, 0.0, 0.3, 0.7, 0.99, 1.01}) {
    const auto points = column_of_points(static_cast<float>(t * reach), 256);
    const ReferenceResult result = reference.trace(points, k_eye, light, true, 64, 7);
    EXPECT_NEAR(mean(result.visibility), disc_beyond(t), result.confidence + 1.0e-5) << "t = " << t;
    EXPECT_LT(result.confidence, 0.01);
  }
}

TEST(EmbreeArea, SlantedSunCastsTheSameSegment) {
  // The edge runs along z and the sun travels along z and down: across the edge its disc is as wide as from the zenith, at a
  // distance of 2 / cos(slant).
  const Scene scene = slab_scene();
  const EmbreeReference reference(scene);
  const double slant = 0.5;
  const Light light = sun({0, static_cast<float>(-std::cos(slant)), static_cast<float>(std::sin(slant))}, 0.02f);
  const double reach = 2.0 / std::cos(slant) * std::tan(0.01);
  for (const double t : {-0.6, 0.0, 0.6}) {
    const auto points = column_of_points(static_cast<float>(t * reach), 256);
    const ReferenceResult result = reference.trace(points, k_eye, light, true, 64, 7);
    // First order in the disc's radius: the ray's height per metre varies by 1 % over the disc.
    EXPECT_NEAR(mean(result.visibility), disc_beyond(t), result.confidence + 0.005) << "t = " << t;
  }
}

TEST(EmbreeArea, LampHalfHiddenByAnEdgeGivesHalf) {
  const Scene scene = slab_scene();
  const EmbreeReference reference(scene);
  for (const LightKind kind : {LightKind::point, LightKind::spot}) {
    Light light = lamp({0, 6, 0}, 1.0f);
    light.kind = kind;
    const auto points = column_of_points(0.0f, 256);
    const ReferenceResult result = reference.trace(points, k_eye, light, true, 64, 3);
    EXPECT_NEAR(mean(result.visibility), 0.5, result.confidence);
  }
  // Seen from x the edge at a third of the way cuts the disc at -x (6 - 2) / 2 for small x.
  const auto points = column_of_points(-0.2f, 1);
  const ReferenceResult result = reference.trace(points, k_eye, lamp({0, 6, 0}, 1.0f), true, 4096, 3);
  EXPECT_NEAR(mean(result.visibility), disc_beyond(-0.2 * 6.0 / 2.0 + 0.2), 0.02);
}

TEST(EmbreeArea, DirectionsBelowTheHorizonDoNotCount) {
  Scene scene = empty_scene();
  add(scene, floor_quad(100.0f));
  // A third of the disc is below the floor's plane; nothing else is there.
  const Light light = sun({-1.0f, -0.05f, 0.0f}, 0.4f);
  const auto points = column_of_points(0.0f, 512);
  for (const int samples : {1, 2, 64}) {
    const ReferenceResult result = EmbreeReference(scene).trace(points, k_eye, light, true, samples, 5);
    EXPECT_EQ(mean(result.visibility), 1.0) << samples << " samples";
    EXPECT_EQ(result.receiver, std::vector<uint8_t>(points.size(), 1));
  }
}

TEST(EmbreeArea, WithoutExtentAreaEqualsHard) {
  const Scene scene = slab_scene();
  const EmbreeReference reference(scene);
  const auto points = column_of_points(0.01f, 64);
  const ReferenceResult area = reference.trace(points, k_eye, sun({0, -1, 0}), true, 64, 5);
  EXPECT_EQ(area.visibility, reference.trace(points, k_eye, sun({0, -1, 0}, 0.5f), false, 64, 5).visibility);
  EXPECT_EQ(area.confidence, 0.0);
}

TEST(EmbreeArea, ConfidenceIntervalHoldsTheTruth) {
  const Scene scene = slab_scene();
  const EmbreeReference reference(scene);
  const Light light = sun({0, -1, 0}, 0.2f);
  const double t = 0.37;
  const auto points = column_of_points(static_cast<float>(t * 2.0 * std::tan(0.1)), 64);
  auto four_a_pixel = points;
  for (SurfacePoint& point : four_a_pixel) point.pixel /= 4;
  for (const auto& set : {points, four_a_pixel}) {
    int held = 0;
    for (uint32_t seed = 0; seed < 200; ++seed) {
      const ReferenceResult result = reference.trace(set, k_eye, light, true, 16, seed);
      held += std::abs(mean(result.visibility) - disc_beyond(t)) <= result.confidence ? 1 : 0;
    }
    EXPECT_GE(held, 190);
  }
}

}  // namespace
}  // namespace gnomon
