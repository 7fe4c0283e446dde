// Which errors the viewer tells, and which end it.
#include <gtest/gtest.h>

#include "app/viewer/attempt.h"
#include "gpu/vulkan.h"

namespace gnomon::viewer {
namespace {

TEST(Attempt, tells_what_was_not_possible) {
  std::string message = "as before";
  EXPECT_TRUE(attempt(message, [] {}));
  EXPECT_EQ(message, "as before");
  EXPECT_FALSE(attempt(message, [] { fail_usage("no such light"); }));
  EXPECT_EQ(message, "no such light");
  EXPECT_FALSE(attempt(message, [] { vk_check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkAllocateMemory"); }));
  EXPECT_NE(message.find("memory is used up"), std::string::npos) << message;
}

TEST(Attempt, ends_with_the_device) {
  std::string message;
  EXPECT_THROW(attempt(message, [] { vk_check(VK_ERROR_DEVICE_LOST, "vkQueueSubmit2"); }), DeviceLost);
  EXPECT_THROW(attempt(message, [] { throw ValidationError("validation (1 messages)"); }), ValidationError);
  EXPECT_EQ(message, "");
}

}  // namespace
}  // namespace gnomon::viewer
