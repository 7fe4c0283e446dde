// The error on the picture against the CPU's own map of it, and the reference as a mask.
#include "frame/shading/error_view.h"

#include "measure/visibility_error.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

// Masks and references with errors of both signs and all sizes, and points that are no receivers.
struct Answers {
  explicit Answers(size_t count) : mask(count), truth(count), receiver(count, 1) {
    for (size_t i = 0; i < count; ++i) {
      mask[i] = static_cast<float>(i % 17) / 16.0f;
      truth[i] = static_cast<float>(i % 23) / 22.0f;
      if (i % 7 == 0) receiver[i] = 0, truth[i] = 0.0f;
    }
  }
  std::vector<float> mask, truth;
  std::vector<uint8_t> receiver;
};

class ErrorViewTest : public testing::TestWithParam<uint32_t> {
 protected:
  ErrorViewTest()
      : view_(make_scene(), {61, 43}, GetParam()), answers_(view_.frame().sample_count()), error_(device(), GetParam()) {
    view_.draw();
    const ErrorView::Reference light{answers_.truth, answers_.receiver};
    error_.set_reference(view_.frame(), std::span(&light, 1));
  }
  static Scene make_scene() {
    Scene scene = test::scene_with({test::floor_part(50.0f)});
    scene.cameras.push_back(look_at("down", {0, 3, 2}, {0, 0, 0}, 40.0));
    scene.lights.push_back(test::make_sun({0.3f, -1, 0}));
    return scene;
  }
  View view_;
  Answers answers_;
  ErrorView error_;
};

TEST_P(ErrorViewTest, IsTheMapOfTheReport) {
  view_.frame().write_mask(0, answers_.mask);
  view_.shade();
  const Image8 shaded = view_.frame().read_display();
  test::run_passes([&](Recorder& recorder) { error_.record(recorder, view_.frame(), 0); });
  const Image8 seen = view_.frame().read_display();
  const Image8 expected =
      signed_error_map(answers_.mask, answers_.truth, answers_.receiver, static_cast<int>(GetParam()), shaded);
  ASSERT_EQ(seen.rgba.size(), expected.rgba.size());
  for (size_t i = 0; i < seen.rgba.size(); ++i) ASSERT_NEAR(seen.rgba[i], expected.rgba[i], 1) << "byte " << i;
}

TEST_P(ErrorViewTest, ReferenceIsShadedLikeAMask) {
  view_.frame().write_mask(0, answers_.truth);
  view_.shade();
  const Image8 expected = view_.frame().read_display();
  view_.frame().write_mask(0, answers_.mask);
  test::run_passes([&](Recorder& recorder) { view_.frame().record_shade(recorder, error_.reference()); });
  EXPECT_EQ(view_.frame().read_display().rgba, expected.rgba);
}

INSTANTIATE_TEST_SUITE_P(Samples, ErrorViewTest, testing::Values(1u, 4u));

// A frame that was made larger, and one that is smaller than its memory, answer as one made in that size.
TEST(FrameResize, IsLikeAFrameOfThatSize) {
  const auto make = [] {
    MeshPart sphere = part_of(0);
    add_sphere(sphere, {0, 1, 0}, 1.0f, 24, 12, {1, 1});
    Scene scene = test::scene_with({test::floor_part(5.0f), std::move(sphere)});
    scene.cameras.push_back(look_at("side", {0, 2.0f, 5}, {0, 0.5f, 0}, 40.0));
    scene.lights.push_back(test::make_sun({0.5f, -1, 0.2f}));
    return scene;
  };
  const TechniqueSpec& spec = find_technique("sample_distribution/pcf");
  for (const uint32_t samples : {1u, 4u}) {
    View resized(make(), {40, 40}, samples);
    const auto technique = spec.make(resized.context(), spec.default_settings());
    const auto frame_of = [&](View& view, Technique& drawn) {
      test::run_passes([&](Recorder& recorder) {
        view.frame().record_surface(recorder);
        drawn.record(recorder, view.frame(), 0);
        view.frame().record_shade(recorder);
      });
    };
    for (const uvec2 size : {uvec2(70, 30), uvec2(33, 51), uvec2(16, 16), uvec2(70, 51)}) {
      resized.frame().resize(size);
      resized.frame().set_camera(resized.scene().cameras[0]);
      frame_of(resized, *technique);
      View made(make(), size, samples);
      const auto fresh = spec.make(made.context(), spec.default_settings());
      frame_of(made, *fresh);
      EXPECT_EQ(resized.frame().read_mask(0), made.frame().read_mask(0)) << size.x << " x " << size.y;
      EXPECT_EQ(resized.frame().read_display().rgba, made.frame().read_display().rgba) << size.x << " x " << size.y;
      EXPECT_EQ(resized.frame().read_points().size(), made.frame().read_points().size());
    }
  }
}

}  // namespace
}  // namespace gnomon
