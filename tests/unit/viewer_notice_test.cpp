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
  EXPECT_EQ(warnings_notice("a.obj", five), "opening a.obj gave 5 warnings:\nfirst\nsecond\nthird\nand 2 more, in the terminal");
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
