// main of the tests that need a device: --file=NAME runs the tests of one source file, so that CTest starts a device per file
// and not per test.
#include "support/device_tests.h"

#include <cstring>
#include <optional>

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

// The gtest filter of the tests that a source file defines; empty when there is none.
std::string tests_of_file(const std::string& name) {
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& info = *suite.GetTestInfo(t);
      const std::string file = info.file();
      if (file.size() > name.size() && file.ends_with("/" + name)) filter += fmt::format("{}.{}:", suite.name(), info.name());
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
      fmt::print(stderr, "{}: no test is defined there\n", argument);
      return 1;
    }
    testing::GTEST_FLAG(filter) = filter;
  }
  testing::AddGlobalTestEnvironment(new gnomon::test::DeviceEnvironment);  // owned by GoogleTest
  testing::UnitTest::GetInstance()->listeners().Append(new gnomon::test::ValidationListener);
  return RUN_ALL_TESTS();
}
