// Warnings of one kind are counted, those of other kinds are not lost among them.
#include "base/warning_limit.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/log.h"
#include "base/warning_watch.h"

namespace gnomon {
namespace {

void flood(int count) {
  for (int i = 0; i < count; ++i) log_warning("texture {} is not there", i);
}

TEST(WarningLimit, TheFirstOfAKindAreShownTheOthersCounted) {
  WarningWatch watch;
  {
    WarningLimit limit;
    flood(3000);
    log_warning("{} is of another kind", 1);
    EXPECT_EQ(watch.texts().size(), WarningLimit::k_shown + 1);
  }
  const auto texts = watch.texts();
  ASSERT_EQ(texts.size(), WarningLimit::k_shown + 2);
  EXPECT_EQ(texts[0], "texture 0 is not there");
  EXPECT_EQ(texts[WarningLimit::k_shown], "1 is of another kind");
  EXPECT_EQ(texts.back(), "and 2995 more like this one: texture 4 is not there");
}

TEST(WarningLimit, FewAreShownAsTheyAre) {
  WarningWatch watch;
  {
    WarningLimit limit;
    flood(static_cast<int>(WarningLimit::k_shown));
  }
  EXPECT_EQ(watch.texts().size(), WarningLimit::k_shown);
}

TEST(WarningLimit, EndsWithItsScope) {
  WarningWatch watch;
  { WarningLimit limit; }
  flood(20);
  EXPECT_EQ(watch.texts().size(), 20u);
}

TEST(WarningLimit, MessagesMadeElsewhereAreOfOneKindOnlyWhereTheyAreTheSame) {
  WarningWatch watch;
  {
    WarningLimit limit;
    for (int i = 0; i < 10; ++i) log_warning("{}", fmt::format("message {}", i));
  }
  EXPECT_EQ(watch.texts().size(), 10u);
}

TEST(WarningLimit, CountsTheWarningsOfEveryThreadOnce) {
  WarningWatch watch;
  {
    WarningLimit outer, inner;
    std::jthread other([] { flood(10); });
    flood(10);
  }
  EXPECT_EQ(watch.texts().size(), WarningLimit::k_shown + 1);
  EXPECT_TRUE(watch.texts().back().starts_with("and 15 more like this one: texture ")) << watch.texts().back();
}

}  // namespace
}  // namespace gnomon
