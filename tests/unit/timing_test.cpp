// The measuring protocol on frames that take what the test says, by a clock that the test holds.
#include "lab/timing/timing.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gnomon {
namespace {

// A frame is "draw" and "read"; frame n takes milliseconds that follow from n, the first `slow` of them a thousand times more.
// Every number of a frame differs from every other: one that is taken for another shows.
class FakeFrames : public TimedFrames {
 public:
  FakeFrames(double& clock_s, std::vector<bool>& apart, int slow) : clock_s_(clock_s), apart_(apart), slow_(slow) {}

  FrameResult draw(bool apart) override {
    if (!apart) ++frame_;
    apart_.push_back(apart);
    const double factor = (frame_ <= slow_ ? 1000.0 : 1.0) * (apart ? 1.0 : 100.0);
    // 1, 2, 3, ... from the first counted frame on, but the fourth, which something else held up.
    const int n = frame_ - slow_;
    const double ms = factor * (n == 4 ? 50.0 : n > 0 ? n : 1);
    clock_s_ += 1.0;
    FrameResult result;
    result.gpu_ms = 2.0 * ms;
    result.wall_ms = 3.0 * ms;
    result.record_ms = 5.0 * ms;
    result.submission_ms = apart ? 0.5 : 0.0;
    result.passes = {{"draw", PassStage::build, 7.0 * ms, 11.0 * ms, 3, 0, 36},
                     {"read", PassStage::resolve, 13.0 * ms, 17.0 * ms, 0, 2, 0}};
    return result;
  }

 private:
  double& clock_s_;
  std::vector<bool>& apart_;
  const int slow_;
  int frame_ = 0;
};

struct Measured {
  Timing timing;
  std::vector<bool> apart;  // of each draw, in order
};

Measured measure(const TimingOptions& options, bool wall) {
  Measured result;
  double clock_s = 100.0;
  FrameTimer timer(std::make_unique<FakeFrames>(clock_s, result.apart, options.warm_up), options, wall);
  result.timing = time_frames(timer, options, [&] { return clock_s; });
  return result;
}

TimingOptions options_of(int frames, int warm_up, double max_seconds = 1e6) {
  TimingOptions options;
  options.frames = frames, options.warm_up = warm_up, options.max_seconds = max_seconds;
  return options;
}

void expect_summary(const Summary& summary, double scale) {
  // Of 1, 2, 3, 50, 5: the median is 3, the nearest rank to 95 % the largest, and the deviations 0, 1, 2, 2, 47.
  EXPECT_DOUBLE_EQ(summary.median, 3.0 * scale);
  EXPECT_DOUBLE_EQ(summary.p95, 50.0 * scale);
  EXPECT_DOUBLE_EQ(summary.mad, 2.0 * scale);
}

TEST(TimingProtocol, WarmUpFramesAreDrawnAndNotCounted) {
  for (const int warm_up : {0, 1, 6}) {
    const Measured measured = measure(options_of(5, warm_up), false);
    EXPECT_EQ(measured.apart.size(), static_cast<size_t>(5 + warm_up));
    EXPECT_EQ(measured.timing.frames, 5);
    EXPECT_EQ(measured.timing.warm_up, warm_up);
    expect_summary(measured.timing.frame_ms, 200.0);
  }
}

TEST(TimingProtocol, TimestampsTimeWholeFrames) {
  const Measured measured = measure(options_of(5, 2), false);
  EXPECT_EQ(measured.apart, std::vector<bool>(7, false));
  const Timing& timing = measured.timing;
  EXPECT_EQ(timing.clock, "gpu timestamps");
  expect_summary(timing.frame_ms, 200.0);
  expect_summary(timing.record_ms, 500.0);
  ASSERT_EQ(timing.passes.size(), 2u);
  expect_summary(timing.passes[0].ms, 700.0);
  expect_summary(timing.passes[1].ms, 1300.0);
}

TEST(TimingProtocol, TheWallClockTimesPassesApartInTurnWithWholeFrames) {
  const Measured measured = measure(options_of(5, 2), true);
  std::vector<bool> turns = {false, false};
  for (int i = 0; i < 5; ++i) turns.insert(turns.end(), {false, true});
  EXPECT_EQ(measured.apart, turns);
  const Timing& timing = measured.timing;
  EXPECT_EQ(timing.clock, "wall clock, each pass submitted alone");
  EXPECT_DOUBLE_EQ(timing.frame_ms.median, 900.0 - 0.5) << "less what an empty submission takes";
  EXPECT_DOUBLE_EQ(timing.frame_ms.p95, 15000.0 - 0.5);
  expect_summary(timing.record_ms, 500.0);
  ASSERT_EQ(timing.passes.size(), 2u);
  expect_summary(timing.passes[0].ms, 11.0);
  expect_summary(timing.passes[1].ms, 17.0);
}

TEST(TimingProtocol, EndsWhenItsTimeIsUpButNotBeforeThreeFrames) {
  EXPECT_EQ(measure(options_of(50, 20, 9.5), false).timing.frames, 10) << "a second each, and the warm-up does not count";
  EXPECT_EQ(measure(options_of(50, 20, 0.0), false).timing.frames, k_min_frames);
  EXPECT_EQ(measure(options_of(2, 0, 0.0), false).timing.frames, 2) << "no more than asked for";
  EXPECT_EQ(measure(options_of(50, 0, 9.5), true).timing.frames, 5) << "two seconds each";
}

TEST(TimingProtocol, ResultsHoldEachNumberUnderItsName) {
  const Timing timing = measure(options_of(5, 2), true).timing;
  EXPECT_DOUBLE_EQ(timing.stage_ms(PassStage::build), 33.0);
  EXPECT_DOUBLE_EQ(timing.stage_ms(PassStage::resolve), 51.0);
  EXPECT_EQ(timing.stage_ms(PassStage::shade), 0.0);
  EXPECT_DOUBLE_EQ(timing.sum_of_passes_ms(), 84.0);
  EXPECT_EQ(timing_to_json(timing), (nlohmann::json{{"mode", "measure"},
                                                    {"clock", timing.clock},
                                                    {"frames", 5},
                                                    {"warm_up", 2},
                                                    {"frame_ms", 899.5},
                                                    {"record_ms", 1500.0},
                                                    {"sum_of_passes_ms", 84.0}}));
  EXPECT_EQ(passes_to_json(timing).at(0), (nlohmann::json{{"name", "draw"},
                                                          {"stage", "build"},
                                                          {"median_ms", 33.0},
                                                          {"p95_ms", 550.0},
                                                          {"mad_ms", 22.0},
                                                          {"draws", 3},
                                                          {"dispatches", 0},
                                                          {"triangles", 36}}));
  EXPECT_EQ(passes_to_json(timing).at(1).at("dispatches"), 2);
}

}  // namespace
}  // namespace gnomon
