// Text from files that must not steer a terminal, nor cut a message off; in messages, in the log, in reports.
#include "base/visible_text.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/log.h"
#include "base/warning_watch.h"
#include "report/html.h"

namespace gnomon {
namespace {

TEST(VisibleText, FitTextIsUnchanged) {
  for (const std::string text : {"", "plain", "two\nlines\tand a tab",
                                 "Stra\xc3\x9f"
                                 "e, \xe6\x97\xa5\xe6\x9c\xac, \xf0\x9f\x8c\xb3"})
    EXPECT_EQ(visible_text(text), text);
  EXPECT_EQ(visible_line("two\nlines\t"), "two\\x0alines\\x09");
}

TEST(VisibleText, ControlCharactersAreShownAsText) {
  EXPECT_EQ(visible_text("\x1b[31mred\x1b[0m"), "\\x1b[31mred\\x1b[0m");
  EXPECT_EQ(visible_text(std::string_view("zero\0more", 9)), "zero\\x00more");
  EXPECT_EQ(visible_text("\r\b\a\x7f"), "\\x0d\\x08\\x07\\x7f");
  EXPECT_EQ(visible_text("\xc2\x9b"
                         "2J"),
            "\\x9b2J")
      << "the eight-bit form of ESC [";
  EXPECT_EQ(visible_text("a\xe2\x80\xae"
                         "b"),
            "a\\u202eb")
      << "text that would run from right to left";
}

TEST(VisibleText, BytesThatAreNoUtf8AreShownAsText) {
  EXPECT_EQ(visible_text("Stra\xdf"
                         "e"),
            "Stra\\xdfe");
  EXPECT_EQ(visible_text("\xe6\x97"), "\\xe6\\x97") << "cut off";
  EXPECT_EQ(visible_text("\xc0\x80"), "\\xc0\\x80") << "longer than needed";
  EXPECT_EQ(visible_text("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a surrogate";
  EXPECT_EQ(visible_text("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80") << "above 0x10ffff";
}

TEST(VisibleText, ErrorsLogAndPagesUseIt) {
  const std::string name("a\x1b[2J\0b", 7);
  EXPECT_STREQ(Error(name + ": is missing").what(), "a\\x1b[2J\\x00b: is missing");
  WarningWatch watch;
  log_warning("{}: is missing", name);
  EXPECT_EQ(watch.texts(), std::vector<std::string>{"a\\x1b[2J\\x00b: is missing"});
  EXPECT_EQ(escape_html("<" + name), "&lt;a\\x1b[2J\\x00b");
}

TEST(VisibleText, TheLogItselfShowsIt) {
  testing::internal::CaptureStderr();
  log_error("a\x1b[2Jb");
  const std::string shown = testing::internal::GetCapturedStderr();
  EXPECT_NE(shown.find("a\\x1b[2Jb"), std::string::npos) << shown;
}

}  // namespace
}  // namespace gnomon
