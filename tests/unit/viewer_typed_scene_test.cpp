// Paths as users type and paste them.
#include "app/viewer/state/typed_scene.h"

#include <gtest/gtest.h>

namespace gnomon::viewer {
namespace {

std::string typed(std::string_view text) { return typed_scene(text, "/home/me"); }

TEST(TypedScene, BlanksAndQuotesAroundItAreLeftOut) {
  EXPECT_EQ(typed("courtyard"), "courtyard");
  EXPECT_EQ(typed("  a b.obj \n"), "a b.obj");
  EXPECT_EQ(typed("'/tmp/a b.obj' "), "/tmp/a b.obj");
  EXPECT_EQ(typed("\"~/a.obj\""), "/home/me/a.obj");
  EXPECT_EQ(typed("' '"), "");
  EXPECT_EQ(typed(""), "");
  EXPECT_EQ(typed("it's.obj"), "it's.obj");
  EXPECT_EQ(typed("'"), "'");
}

TEST(TypedScene, TheHomeFolder) {
  EXPECT_EQ(typed("~/models/a.obj"), "/home/me/models/a.obj");
  EXPECT_EQ(typed("~other/a.obj"), "~other/a.obj");
  EXPECT_EQ(typed("a~/b.obj"), "a~/b.obj");
  EXPECT_EQ(typed_scene("~/a.obj", {}), "~/a.obj");
}

TEST(TypedScene, AddressesOfFiles) {
  EXPECT_EQ(typed("file:///tmp/two%20boxes.obj"), "/tmp/two boxes.obj");
  EXPECT_EQ(typed("file://localhost/tmp/%C3%A4.obj\r\n"), "/tmp/\xC3\xA4.obj");
  EXPECT_EQ(typed("file:///tmp/100%.obj"), "/tmp/100%.obj");
  EXPECT_EQ(typed("file:///tmp/%zz%4"), "/tmp/%zz%4");
  EXPECT_EQ(typed("/tmp/a%20b.obj"), "/tmp/a%20b.obj") << "a path is no address";
}

}  // namespace
}  // namespace gnomon::viewer
