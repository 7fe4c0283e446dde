// Other programs: what they write, how they end.
#include "base/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "base/error.h"

namespace gnomon {
namespace {

TEST(ChildProcess, CollectsBothOutputsAndTheExitCode) {
  ChildProcess child({"sh", "-c", "echo one; echo two >&2; exit 3"});
  child.wait();
  EXPECT_EQ(child.output(), "one\ntwo\n");
  EXPECT_EQ(child.exit_code(), 3);
  EXPECT_FALSE(child.running());
}

TEST(ChildProcess, TakesMoreThanAPipeHolds) {
  ChildProcess child({"sh", "-c", "i=0; while [ $i -lt 20000 ]; do echo 0123456789; i=$((i + 1)); done"});
  while (child.running()) usleep(1000);
  EXPECT_EQ(child.output().size(), 220000u);
  EXPECT_EQ(child.exit_code(), 0);
}

TEST(ChildProcess, WordsArePassedAsTheyAre) {
  ChildProcess child({"printf", "%s|", "a b", "$HOME", "'"});
  child.wait();
  EXPECT_EQ(child.output(), "a b|$HOME|'|");
}

TEST(ChildProcess, HasAnEmptyInput) {
  ChildProcess child({"cat"});
  child.wait();
  EXPECT_EQ(child.exit_code(), 0);
}

TEST(ChildProcess, CanBeStopped) {
  ChildProcess child({"sleep", "1000"});
  EXPECT_TRUE(child.running());
  child.stop();
  child.wait();
  EXPECT_EQ(child.exit_code(), 128 + SIGTERM);
  const ChildProcess dropped({"sleep", "1000"});  // ends with its object
}

TEST(ChildProcess, NamesAProgramThatIsNotThere) {
  try {
    const ChildProcess child({"/absent/program"});
    ADD_FAILURE() << "it was started";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/absent/program"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gnomon
