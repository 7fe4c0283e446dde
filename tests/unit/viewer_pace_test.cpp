// What a slow view draws, frame by frame.
#include "app/viewer/window/pace.h"
#include "app/viewer/window/render_scale.h"

#include <gtest/gtest.h>

namespace gnomon::viewer {
namespace {

using Draws = Pace::Draws;

constexpr float k_target = 40.0f;

// Frames of 10 ms.
struct Clock {
  Pace pace;
  bool settled = false;  // the size of a fast view
  Pace::Clock::time_point now = Pace::Clock::time_point() + std::chrono::hours(1);

  Draws frame(bool changed, float ms, bool may_shrink = true, bool may_stay = true) {
    now += std::chrono::milliseconds(10);
    const Draws draws = pace.next({changed, false, may_shrink, may_stay && (settled || pace.slow())}, now);
    if (pace.draws_once()) pace.done(ms, k_target);
    pace.add_frame(ms, k_target, true);
    return draws;
  }
  // The last of so many.
  Draws frames(int count, bool changed, float ms, bool may_shrink = true, bool may_stay = true) {
    Draws draws = Draws::full;
    for (int i = 0; i < count; ++i) draws = frame(changed, ms, may_shrink, may_stay);
    return draws;
  }
  void become_slow() { frames(5, false, 200.0f); }
};

TEST(Pace, AFastViewIsDrawnInFull) {
  Clock clock;
  for (const bool changed : {false, true, false}) {
    EXPECT_EQ(clock.frames(100, changed, 45.0f), Draws::full);
    EXPECT_FALSE(clock.pace.slow());
  }
}

TEST(Pace, AFastViewIsDrawnOnceAtRest) {
  Clock clock;
  clock.settled = true;
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(clock.frames(50, true, 30.0f), Draws::full);
    EXPECT_FALSE(clock.pace.draws_once());
    EXPECT_EQ(clock.frames(19, false, 30.0f), Draws::full);
    EXPECT_FALSE(clock.pace.stays());
    EXPECT_EQ(clock.frame(false, 120.0f), Draws::full);
    EXPECT_TRUE(clock.pace.stays());
    EXPECT_EQ(clock.frames(50, false, 1.0f), Draws::nothing);
    // Something else lies over it.
    clock.now += std::chrono::milliseconds(10);
    EXPECT_EQ(clock.pace.next({false, true, true, true}, clock.now), Draws::full);
    EXPECT_TRUE(clock.pace.draws_once()) << "at rest, not as while it moves";
    clock.pace.done(120.0f, k_target);
    EXPECT_EQ(clock.frame(false, 1.0f), Draws::nothing);
  }
  EXPECT_FALSE(clock.pace.slow());
}

TEST(Pace, OneLongFrameDoesNotMakeAViewSlow) {
  Clock clock;
  for (int i = 0; i < 20; ++i) {
    clock.frames(3, false, 300.0f);
    clock.frame(false, 20.0f);
  }
  EXPECT_FALSE(clock.pace.slow());
}

TEST(Pace, ASlowViewHasSmallMapsWhileItMovesAndIsDrawnOnceAtRest) {
  Clock clock;
  clock.become_slow();
  EXPECT_TRUE(clock.pace.slow());
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(clock.frame(true, 30.0f), Draws::small_maps) << "at once";
    EXPECT_FALSE(clock.pace.shows_full());
    EXPECT_EQ(clock.frames(50, true, 30.0f), Draws::small_maps);
    int full = 0, last_full = 0;
    for (int i = 0; i < 60; ++i) {
      const Draws draws = clock.frame(false, 200.0f);
      if (draws == Draws::full) ++full, last_full = i;
    }
    EXPECT_EQ(full, 1);
    EXPECT_NEAR(last_full, 20, 1) << "200 ms after the last change";
    EXPECT_TRUE(clock.pace.shows_full());
  }
}

TEST(Pace, WhatIsGivenUpIsDrawnAgain) {
  Clock clock;
  clock.become_slow();
  clock.frame(true, 30.0f);
  clock.now += std::chrono::seconds(1);
  EXPECT_EQ(clock.pace.next({false, false, true, true}, clock.now), Draws::full);
  EXPECT_TRUE(clock.pace.draws_once());
  clock.pace.give_up();
  EXPECT_FALSE(clock.pace.shows_full());
  EXPECT_EQ(clock.frame(false, 200.0f), Draws::full);
  EXPECT_EQ(clock.frame(false, 200.0f), Draws::nothing);
}

TEST(Pace, WhatIsLookedAtIsDrawnInFull) {
  Clock clock;
  clock.become_slow();
  EXPECT_EQ(clock.frames(10, true, 200.0f, false, false), Draws::full);
  EXPECT_EQ(clock.frames(100, false, 200.0f, false, false), Draws::full);
  EXPECT_FALSE(clock.pace.draws_once()) << "its overlays would stay";
  // What had an overlay does not stay.
  EXPECT_EQ(clock.frame(false, 200.0f), Draws::full);
  EXPECT_EQ(clock.frame(false, 200.0f), Draws::nothing);
  // A reference is compared with the picture at rest only.
  EXPECT_EQ(clock.frames(10, true, 30.0f, true, false), Draws::small_maps);
  EXPECT_EQ(clock.frames(100, false, 200.0f, true, false), Draws::full);
}

TEST(Pace, MapsBecomeSmallerWhereThatIsNotEnough) {
  Clock clock;
  clock.become_slow();
  const uint32_t first = clock.pace.divisor();
  clock.frames(4, true, 80.0f);
  EXPECT_EQ(clock.pace.divisor(), 2 * first);
  clock.frames(400, true, 80.0f);
  EXPECT_EQ(clock.pace.divisor(), 2 * first) << "smaller ones show nothing";
  clock.pace.forget();
  EXPECT_EQ(clock.pace.divisor(), first);
  EXPECT_FALSE(clock.pace.slow());
}

TEST(Pace, AViewThatIsFastAgainIsDrawnInFull) {
  Clock clock;
  clock.become_slow();
  clock.frame(true, 30.0f);
  clock.frames(40, false, 25.0f);  // fewer texels were asked for
  EXPECT_FALSE(clock.pace.slow());
  EXPECT_EQ(clock.frame(true, 25.0f), Draws::full);
}

TEST(Pace, WhereSmallerMapsCannotBeHadNoViewIsSlow) {
  Clock clock;
  clock.become_slow();
  clock.pace.refuse();
  EXPECT_EQ(clock.frames(100, true, 200.0f), Draws::full);
  clock.pace.forget();
  clock.become_slow();
  EXPECT_TRUE(clock.pace.slow());
}

// Together with the size: frames of fixed_ms + full_ms * scale^2.
bool becomes_slow(float fixed_ms, float full_ms, float start) {
  Pace pace;
  RenderScale scale(k_target, start);
  for (int i = 0; i < 200 && !pace.slow(); ++i) {
    const float ms = fixed_ms + full_ms * scale.scale() * scale.scale();
    pace.add_frame(ms, k_target, scale.exhausted());
    scale.add_frame(ms);
  }
  return pace.slow();
}

TEST(Pace, OnlyWhatNoSizeMakesFastIsSlow) {
  EXPECT_FALSE(becomes_slow(2.0f, 58.0f, 1.0f));
  EXPECT_FALSE(becomes_slow(5.0f, 300.0f, 1.0f));
  EXPECT_FALSE(becomes_slow(20.0f, 100.0f, 0.35f));
  EXPECT_TRUE(becomes_slow(100.0f, 30.0f, 1.0f));
  EXPECT_TRUE(becomes_slow(100.0f, 300.0f, 0.35f));
  EXPECT_TRUE(becomes_slow(5.0f, 3000.0f, 0.35f)) << "no size is small enough";
}

TEST(Pace, AnotherTargetBeginsAnew) {
  Clock clock;
  clock.become_slow();
  clock.pace.add_frame(100.0f, 200.0f, true);
  EXPECT_FALSE(clock.pace.slow());
}

}  // namespace
}  // namespace gnomon::viewer
