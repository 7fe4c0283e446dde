// First places of the viewer's windows.
#include "app/viewer/window/window_places.h"

#include <gtest/gtest.h>

#include <vector>

namespace gnomon::viewer {
namespace {

constexpr float k_letter = 13.0f;

bool overlap(const Place& a, const Place& b) {
  return a.corner.x < b.end().x && b.corner.x < a.end().x && a.corner.y < b.end().y && b.corner.y < a.end().y;
}

TEST(WindowPlaces, NoneCoversAnotherFrom640x600On) {
  for (const float width : {640.0f, 800.0f, 860.0f, 960.0f, 985.0f, 1000.0f, 1100.0f, 1280.0f, 1920.0f, 3840.0f}) {
    for (const float height : {600.0f, 640.0f, 800.0f, 1080.0f, 2160.0f}) {
      SCOPED_TRACE(testing::Message() << width << " x " << height);
      const WindowPlaces places = first_places({width, height}, k_letter);
      const std::vector<Place> all = {places.panel, places.tools, places.pick, places.map};
      for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_GE(all[i].corner.x, 0.0f);
        EXPECT_GE(all[i].corner.y, 0.0f);
        EXPECT_LE(all[i].end().x, width);
        EXPECT_LE(all[i].end().y, height);
        for (size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(all[i], all[j])) << i << ", " << j;
      }
      EXPECT_FALSE(places.panel_folded);
      for (const Place& place : {places.pick, places.map}) {
        EXPECT_GE(place.size.x, 200.0f);
        EXPECT_GE(place.size.y, 200.0f);
      }
    }
  }
}

TEST(WindowPlaces, SmallScreensKeepReadableWindows) {
  const WindowPlaces places = first_places({400.0f, 300.0f}, k_letter);
  EXPECT_TRUE(places.panel_folded && places.tools_folded) << "there is a picture to be seen";
  EXPECT_GE(places.panel.corner.y, places.tools.end().y) << "titles do not lie on each other";
  EXPECT_FALSE(first_places({640.0f, 400.0f}, k_letter).panel_folded);
  for (const Place& place : {places.panel, places.pick, places.map}) {
    EXPECT_GE(place.size.x, 200.0f);
    EXPECT_GE(place.size.y, 100.0f);
    EXPECT_LE(place.end().x, 400.0f);
  }
}

}  // namespace
}  // namespace gnomon::viewer
