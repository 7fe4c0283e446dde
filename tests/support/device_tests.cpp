// main of the tests that need a device: --file=NAME runs the tests of one source file (of those of --gtest_filter), so that
// CTest starts a device per file and not per test.
#include "support/device_tests.h"

#include <fnmatch.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <sstream>

namespace gnomon::test {
namespace {

std::optional<Device>& storage() {
  static std::optional<Device> device;
  return device;
}

std::vector<std::function<void()>>& drops() {
  static std::vector<std::function<void()>> list;
  return list;
}

class DeviceEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    try {
      storage().emplace(DeviceOptions{"", true});
      const DeviceInfo& info = device().info();
      fmt::print("device: {} ({} {})\n", info.name, info.driver, info.driver_version);
    } catch (const Error& error) {
      FAIL() << error.what();
    }
  }
  void TearDown() override {
    if (!storage()) return;
    for (auto drop = drops().rbegin(); drop != drops().rend(); ++drop) (*drop)();
    drops().clear();
    device().wait_idle();
    try {
      device().check_validation();
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
    EXPECT_EQ(device().allocated_bytes(), 0u) << "a test left buffers or images behind";
    storage().reset();
  }
};

// Asks after every test, so that the message is printed with the test that caused it.
class ValidationListener : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo&) override {
    if (!storage()) return;
    try {
      device().check_validation();
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
};

// Whether GoogleTest's filter ("A.*:B.c-A.d") chooses a test.
bool chosen(const std::string& filter, const std::string& test) {
  const size_t minus = filter.find('-');
  const auto any = [&](std::string patterns) {
    std::replace(patterns.begin(), patterns.end(), ':', '\n');
    std::istringstream lines(patterns);
    for (std::string pattern; std::getline(lines, pattern);) {
      if (fnmatch(pattern.c_str(), test.c_str(), 0) == 0) return true;
    }
    return false;
  };
  const std::string wanted = filter.substr(0, minus);
  return any(wanted.empty() ? "*" : wanted) && (minus == std::string::npos || !any(filter.substr(minus + 1)));
}

// The gtest filter of the tests that a source file defines, of those that --gtest_filter chooses; empty when there is none.
std::string tests_of_file(const std::string& name) {
  const std::string given = testing::GTEST_FLAG(filter);
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& info = *suite.GetTestInfo(t);
      const std::string file = info.file();
      const std::string test = fmt::format("{}.{}", suite.name(), info.name());
      if (file.size() > name.size() && file.ends_with("/" + name) && chosen(given, test)) filter += test + ":";
    }
  }
  return filter;
}

}  // namespace

Device& device() {
  if (!storage()) fail_device("the tests have no Vulkan device");
  return *storage();
}

void at_exit(std::function<void()> drop) { drops().push_back(std::move(drop)); }

FrameResult run_passes(const std::function<void(Recorder&)>& record, TimingMode mode, bool isolate) {
  Recorder recorder(device(), mode, isolate);
  recorder.begin();
  record(recorder);
  return recorder.finish();
}

}  // namespace gnomon::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (!argument.starts_with("--file=")) continue;
    const std::string filter = gnomon::test::tests_of_file(argument.substr(std::strlen("--file=")));
    if (filter.empty()) {
      fmt::print(stderr, "{}: no test is defined there, or none that --gtest_filter chooses\n", argument);
      return 1;
    }
    testing::GTEST_FLAG(filter) = filter;
  }
  testing::AddGlobalTestEnvironment(new gnomon::test::DeviceEnvironment);  // owned by GoogleTest
  testing::UnitTest::GetInstance()->listeners().Append(new gnomon::test::ValidationListener);
  return RUN_ALL_TESTS();
}
