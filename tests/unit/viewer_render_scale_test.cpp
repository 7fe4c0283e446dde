// The size of the viewer's picture against frames of known cost.
#include "app/viewer/window/render_scale.h"

#include <gtest/gtest.h>

namespace gnomon::viewer {
namespace {

// A device whose frame takes fixed_ms + full_ms * scale^2.
struct Device {
  float fixed_ms, full_ms;
  float frame(const RenderScale& scale) const { return fixed_ms + full_ms * scale.scale() * scale.scale(); }
  void run(RenderScale& scale, int frames) const {
    for (int i = 0; i < frames; ++i) scale.add_frame(frame(scale));
  }
};

TEST(RenderScale, ComesToRestBelowTheTarget) {
  for (const Device device : {Device{5, 400}, Device{20, 120}, Device{0, 700}, Device{35, 60}}) {
    for (const float start : {RenderScale::k_least, 0.5f, 1.0f}) {
      RenderScale scale(50.0f, start);
      device.run(scale, 400);
      const float rested = scale.scale();
      EXPECT_LE(device.frame(scale), 50.0f) << device.fixed_ms << " + " << device.full_ms << " from " << start;
      // One step larger would be too slow, or there is none.
      const float larger = rested * 1.1892071f;
      EXPECT_TRUE(larger > 1.01f || device.fixed_ms + device.full_ms * larger * larger > 0.95f * 50.0f) << rested;
      for (int i = 0; i < 60; ++i) {
        scale.add_frame(device.frame(scale));
        EXPECT_EQ(scale.scale(), rested) << "it does not rest";
      }
    }
  }
}

TEST(RenderScale, ReactsToASlowDeviceWithinAFewFrames) {
  RenderScale scale(50.0f, 1.0f);
  const Device device{10, 1000};
  device.run(scale, 8);
  EXPECT_LE(device.frame(scale), 75.0f);
}

TEST(RenderScale, IsFullWhereThatIsFastEnough) {
  RenderScale scale(50.0f, 0.35f);
  Device{1, 10}.run(scale, 200);
  EXPECT_EQ(scale.scale(), 1.0f);
}

// A map that takes longer than the target is not paid for with a picture of a few pixels.
TEST(RenderScale, KeepsPixelsWhereTheyAreNotWhatIsSlow) {
  RenderScale scale(50.0f, 1.0f);
  const Device device{300, 200};
  device.run(scale, 600);
  EXPECT_GE(scale.scale(), 0.5f);
  EXPECT_LE(device.frame(scale), 300.0f * 4.0f / 3.0f + 1.0f);
}

TEST(RenderScale, OneSlowFrameChangesNothing) {
  RenderScale scale(50.0f, 1.0f);
  const Device device{5, 30};
  device.run(scale, 50);
  scale.add_frame(80.0f);
  device.run(scale, 20);
  EXPECT_EQ(scale.scale(), 1.0f);
}

}  // namespace
}  // namespace gnomon::viewer
