// What the tests that need a Vulkan device share: one device with core and synchronization validation. Whatever validation says
// fails the test during which it was said. A machine without a Vulkan device fails every test.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "base/error.h"
#include "gpu/recorder.h"

namespace gnomon::test {

Device& device();

// For objects that outlive a test (a scene that many tests look at): called before the device goes.
void at_exit(std::function<void()> drop);

FrameResult run_passes(const std::function<void(Recorder&)>& record, TimingMode mode = TimingMode::play, bool isolate = false);

// The message of the Error that `call` throws, with that exit code; fails the test when it throws none.
template <class Call>
std::string error_of(const Call& call, ExitCode code) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

}  // namespace gnomon::test
