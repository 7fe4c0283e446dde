// What the recorder says about its passes: draws, dispatches, triangles, times.
#include <algorithm>
#include <set>

#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

// Boxes of 12 triangles in a row before the camera, one behind it, and a floor.
Scene row_of_boxes() {
  std::vector<MeshPart> parts = {test::floor_part(30.0f)};
  for (int i = 0; i < 5; ++i) {
    const vec3 at(-4.0f + 2.0f * static_cast<float>(i), 0.5f, 0.0f);
    parts.push_back(test::box_part(at - vec3(0.4f), at + vec3(0.4f)));
  }
  parts.push_back(test::box_part({-1, 1, 20}, {1, 3, 22}));
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("front", {0, 3, 9}, {0, 0, 0}, 50.0));
  scene.lights.push_back(test::make_sun({0.3f, -1, -0.2f}));
  return scene;
}

const PassResult& pass_named(const FrameResult& frame, std::string_view name) {
  for (const PassResult& pass : frame.passes) {
    if (pass.name == name) return pass;
  }
  fail("no pass '{}'", name);
}

TEST(Recorder, CountersEqualWhatIsInTheView) {
  View view(row_of_boxes());
  const FrameResult frame = view.draw();
  ASSERT_EQ(frame.passes.size(), 3u);
  EXPECT_EQ(frame.passes[0].name, "surface/cull");
  EXPECT_EQ(frame.passes[0].dispatches, 1u);
  const PassResult& draw = pass_named(frame, "surface/draw");
  EXPECT_EQ(draw.draws, 6u) << "the floor and five boxes; one box lies behind the camera";
  if (device().info().pipeline_statistics) {
    EXPECT_EQ(draw.triangles, 2u + 5u * 12u);
  }
  EXPECT_EQ(draw.dispatches, 0u);
  EXPECT_EQ(draw.stage, PassStage::surface);
}

TEST(Recorder, EveryModeCountsTheSame) {
  View view(row_of_boxes());
  std::set<std::string> seen;
  for (const TimingMode mode : {TimingMode::play, TimingMode::measure}) {
    for (const bool isolate : {false, true}) {
      const FrameResult frame =
          test::run_passes([&](Recorder& recorder) { view.frame().record_surface(recorder); }, mode, isolate);
      std::string text;
      for (const PassResult& pass : frame.passes)
        text += fmt::format("{} {} {} {};", pass.name, pass.draws, pass.dispatches, pass.triangles);
      seen.insert(text);
    }
  }
  EXPECT_EQ(seen.size(), 1u) << *seen.begin() << "\n" << *seen.rbegin();
}

TEST(Recorder, IsolatedPassesHaveTimesThatAddUp) {
  View view(row_of_boxes());
  double longest = 0.0;
  for (int i = 0; i < 10; ++i) {
    const FrameResult frame =
        test::run_passes([&](Recorder& recorder) { view.frame().record_surface(recorder); }, TimingMode::measure, true);
    double sum = 0.0;
    for (const PassResult& pass : frame.passes) {
      EXPECT_GE(pass.wall_ms, 0.0) << pass.name;
      sum += pass.wall_ms;
    }
    EXPECT_NEAR(frame.wall_ms, sum, 1e-6 * sum);
    EXPECT_GT(frame.record_ms, 0.0);
    longest = std::max(longest, sum);
  }
  // What an empty submission takes is taken off, and beside other work that may be more than passes as small as these.
  EXPECT_GT(longest, 0.0);
}

TEST(Recorder, PassesLieWithinTheFrame) {
  View view(row_of_boxes());
  const FrameResult frame =
      test::run_passes([&](Recorder& recorder) { view.frame().record_surface(recorder); }, TimingMode::measure);
  double sum = 0.0;
  for (const PassResult& pass : frame.passes) {
    EXPECT_GE(pass.gpu_ms, 0.0) << pass.name;
    EXPECT_EQ(pass.wall_ms, 0.0) << pass.name;
    sum += pass.gpu_ms;
  }
  EXPECT_LE(sum, frame.gpu_ms * (1.0 + 1e-9));
  // No lower bound on a software device: its timestamps lie (docs/measuring.md).
  if (!device().info().software) {
    EXPECT_GT(sum, 0.5 * frame.gpu_ms);
  }
  EXPECT_GT(frame.wall_ms, 0.0);
}

TEST(Recorder, CanBeUsedAgain) {
  View view(row_of_boxes());
  Recorder recorder(device(), TimingMode::play, false);
  for (int i = 0; i < 3; ++i) {
    recorder.begin();
    view.frame().record_surface(recorder);
    const FrameResult frame = recorder.finish();
    EXPECT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(pass_named(frame, "surface/draw").draws, 6u);
  }
}

TEST(Recorder, AFrameCanBeGivenUpBetweenPasses) {
  View view(row_of_boxes());
  Recorder recorder(device(), TimingMode::play, true);
  int asked = 0;
  recorder.give_up_when([&] { return ++asked == 2; });
  recorder.begin();
  EXPECT_THROW(view.frame().record_surface(recorder), GivenUp);
  EXPECT_EQ(asked, 2) << "passes";
  // The next frame is a whole one, of the same images.
  recorder.begin();
  view.frame().record_surface(recorder);
  const FrameResult frame = recorder.finish();
  EXPECT_EQ(frame.passes.size(), 3u);
  EXPECT_EQ(pass_named(frame, "surface/draw").draws, 6u);
  device().check_validation();
}

TEST(Recorder, FrameWithoutPassesIsEmpty) {
  const FrameResult frame = test::run_passes([](Recorder&) {});
  EXPECT_TRUE(frame.passes.empty());
  EXPECT_EQ(frame.gpu_ms, 0.0);
}

TEST(Recorder, TooManyPassesIsAnErrorThatNamesThePass) {
  const std::string message = test::error_of(
      [] {
        test::run_passes([](Recorder& recorder) {
          for (uint32_t i = 0; i <= Recorder::k_max_passes; ++i)
            recorder.pass(fmt::format("pass {}", i), PassStage::other, {}, [](Commands&) {});
        });
      },
      ExitCode::failure);
  EXPECT_NE(message.find(fmt::format("'pass {}'", Recorder::k_max_passes)), std::string::npos) << message;
}

TEST(Recorder, AFrameThatFailsHasNeverHappened) {
  ImageInfo info;
  info.name = "picture";
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  const Image picture(device(), info);
  const auto use = [&](Recorder& recorder, Use how) {
    recorder.pass("use", PassStage::other, {{picture, how}}, [](Commands&) {});
  };
  Recorder kept(device(), TimingMode::play, false);
  kept.frame([&] { use(kept, Use::copy_write); });
  const auto fails = [&](Recorder& recorder) {
    use(recorder, Use::compute_read);
    recorder.pass("fails", PassStage::other, {{picture, Use::copy_read}}, [](Commands&) { fail("no"); });
  };
  EXPECT_EQ(test::error_of([&] { kept.frame([&] { fails(kept); }); }, ExitCode::failure), "no");
  EXPECT_EQ(picture.state().layout, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  // The same where nobody said frame(): a recorder that goes away, and one that begins again.
  test::error_of([&] { test::run_passes(fails); }, ExitCode::failure);
  EXPECT_EQ(picture.state().layout, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  kept.begin();
  test::error_of([&] { fails(kept); }, ExitCode::failure);
  // A barrier from a layout that the image never had would be what validation says.
  kept.frame([&] { use(kept, Use::compute_read); });
  // What a frame names may be gone when it fails.
  test::error_of(
      [&] {
        kept.frame([&] {
          const Image gone(device(), info);
          kept.pass("use", PassStage::other, {{gone, Use::copy_write}}, [](Commands&) { fail("no"); });
        });
      },
      ExitCode::failure);
  kept.frame([] {});
}

TEST(Recorder, StagesHaveNames) {
  std::set<std::string_view> names;
  for (const PassStage stage : {PassStage::surface, PassStage::build, PassStage::resolve, PassStage::shade, PassStage::other}) {
    names.insert(stage_name(stage));
  }
  EXPECT_EQ(names.size(), 5u);
}

}  // namespace
}  // namespace gnomon
