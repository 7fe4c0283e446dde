// The folders of the user.
#include "base/user_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace gnomon {
namespace {

// Sets a variable (null: unsets it), and restores it in the end.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(UserFolder, FollowsTheVariablesThenTheHome) {
  const Variable home("HOME", "/home/me");
  {
    const Variable cache("XDG_CACHE_HOME", "/fast"), state("XDG_STATE_HOME", "/kept");
    EXPECT_EQ(user_folder(UserFolder::cache), "/fast/gnomon");
    EXPECT_EQ(user_folder(UserFolder::state), "/kept/gnomon");
  }
  const Variable cache("XDG_CACHE_HOME", nullptr), state("XDG_STATE_HOME", "");
  EXPECT_EQ(user_folder(UserFolder::cache), "/home/me/.cache/gnomon");
  EXPECT_EQ(user_folder(UserFolder::state), "/home/me/.local/state/gnomon");
  const Variable homeless("HOME", nullptr);
  EXPECT_TRUE(user_folder(UserFolder::cache).empty());
}

}  // namespace
}  // namespace gnomon
