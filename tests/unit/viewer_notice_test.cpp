// What the viewer tells though nothing failed.
#include "app/viewer/notice.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/log.h"
#include "base/warning_watch.h"

namespace gnomon::viewer {
namespace {

TEST(Notice, CountsWarningsAndShowsTheFirst) {
  EXPECT_EQ(warnings_notice("a.obj", {}), "");
  const std::vector<std::string> one = {"first"}, five = {"first", "second", "third", "fourth", "fifth"};
  EXPECT_EQ(warnings_notice("a.obj", one), "opening a.obj gave 1 warning:\nfirst");
  EXPECT_EQ(warnings_notice("a.obj", five),
            "opening a.obj gave 5 warnings:\nfirst\nsecond\nthird\nand 2 more, in the terminal");
}

TEST(Notice, OfAPictureNamesWhatItHoldsBesideItsCommand) {
  EXPECT_EQ(picture_notice("a.png", {}), "a.png is written");
  EXPECT_EQ(picture_notice("a.png", {"the error", false}),
            "a.png is written; it also shows the error, which its command does not draw");
  EXPECT_EQ(picture_notice("a.png", {"", true}), "a.png is written, of the first side alone");
  EXPECT_EQ(picture_notice("a.png", {"the error", true}),
            "a.png is written, of the first side alone; it also shows the error, which its command does not draw");
}

TEST(Notice, OfSeveralFilesNamesThoseThatAreNotOpened) {
  const std::vector<std::string> one = {"/a/b.obj"}, two = {"/a/b.obj", "/a/c d.glb"}, six = {"1.obj", "2", "3", "4", "5", "6"};
  EXPECT_EQ(drop_notice(one), "");
  EXPECT_EQ(drop_notice(two), "one scene at a time: b.obj is opened, not c d.glb");
  EXPECT_EQ(drop_notice(six), "one scene at a time: 1.obj is opened, not 2, 3, 4, 2 more");
}

TEST(Notices, GoByThemselvesEachInItsTime) {
  Notices notices;
  notices.add("");
  EXPECT_EQ(notices.text(), "");
  notices.add("a picture", 8.0);
  notices.add("warnings", 30.0);
  notices.pass(60.0);  // a frame that took a minute, in which neither was seen
  EXPECT_EQ(notices.text(), "a picture\nwarnings");
  notices.pass(7.9);
  EXPECT_EQ(notices.text(), "a picture\nwarnings");
  notices.pass(0.2);
  EXPECT_EQ(notices.text(), "warnings");
  notices.clear();
  EXPECT_EQ(notices.text(), "");
}

TEST(Notices, TheNewestStay) {
  Notices notices;
  for (const char* text : {"1", "2", "3", "4", "5"}) notices.add(text);
  EXPECT_EQ(notices.text(), "2\n3\n4\n5");
}

TEST(WarningWatch, HearsWarningsOfEveryThreadWhileItLives) {
  log_warning("before");
  const WarningWatch watch;
  log_info("an information");
  log_warning("one of {}", 2);
  std::thread([] { log_warning("of a thread"); }).join();
  {
    const WarningWatch other;
    log_warning("for both");
    EXPECT_EQ(other.texts(), (std::vector<std::string>{"for both"}));
  }
  EXPECT_EQ(watch.texts(), (std::vector<std::string>{"one of 2", "of a thread", "for both"}));
}

}  // namespace
}  // namespace gnomon::viewer
