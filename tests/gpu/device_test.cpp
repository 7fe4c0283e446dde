// The choice of a device, and requests that it cannot meet.
#include "frame/frame.h"
#include "gpu/device_errors.h"
#include "support/device_tests.h"
#include "support/scenes.h"

namespace gnomon {
namespace {

using test::device;
using test::error_of;

TEST(Device, UnknownNameIsAnErrorThatListsTheDevices) {
  const std::string message = error_of([] { Device({"no such device", false}); }, ExitCode::device);
  EXPECT_NE(message.find("'no such device'"), std::string::npos) << message;
  for (const DeviceInfo& info : list_devices()) EXPECT_NE(message.find(info.name), std::string::npos) << message;
}

TEST(Device, NumberBeyondTheListIsAnError) {
  const std::string message = error_of([] { Device({"4711", false}); }, ExitCode::device);
  EXPECT_NE(message.find(device().info().name), std::string::npos) << message;
}

TEST(Device, IsFoundByPartOfItsNameInAnyCase) {
  std::string part = device().info().name.substr(0, 5);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const Device other({part, false});
  EXPECT_EQ(other.info().name.substr(0, 5), device().info().name.substr(0, 5));
}

TEST(Device, SaysWhatItIs) {
  const DeviceInfo& info = device().info();
  EXPECT_FALSE(info.name.empty());
  EXPECT_FALSE(info.driver.empty());
  EXPECT_TRUE(info.missing.empty());
  EXPECT_GT(info.memory_bytes, 0u);
  ASSERT_FALSE(info.sample_counts.empty());
  EXPECT_EQ(info.sample_counts.front(), 1);
  EXPECT_EQ(info.software, info.type == "cpu");
}

TEST(Device, UnsupportedSampleCountIsAnErrorThatListsTheCounts) {
  Scene scene = test::scene_with({test::floor_part(1.0f)});
  const GpuScene gpu_scene(device(), scene);
  const Light sun = test::make_sun({0, -1, 0});
  for (const uint32_t samples : {0u, 3u, 64u}) {
    const std::string message = error_of(
        [&] {
          Frame(device(), gpu_scene, {16, 16}, samples, std::span(&sun, 1));
        },
        ExitCode::device);
    EXPECT_NE(message.find(fmt::format("{} samples", samples)), std::string::npos) << message;
    EXPECT_NE(message.find(fmt::format("{}", fmt::join(device().info().sample_counts, ", "))), std::string::npos) << message;
  }
}

TEST(Device, SceneWithoutLightOrTrianglesIsAnError) {
  Scene scene = test::scene_with({test::floor_part(1.0f)});
  const GpuScene gpu_scene(device(), scene);
  error_of([&] { Frame(device(), gpu_scene, {16, 16}, 1, {}); }, ExitCode::failure);
  Scene empty = test::scene_with({});
  error_of([&] { GpuScene(device(), empty); }, ExitCode::failure);
}

TEST(Device, ValidationIsOnAndAnyMessageIsAnError) {
  // A buffer with usage 0: the specification forbids it, no driver minds.
  VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = 4;
  VkBuffer buffer = VK_NULL_HANDLE;
  vkCreateBuffer(device().handle(), &info, nullptr, &buffer);
  if (buffer) vkDestroyBuffer(device().handle(), buffer, nullptr);
  std::string message;
  try {
    device().check_validation();
  } catch (const ValidationError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("usage"), std::string::npos) << message;
}

TEST(Device, SynchronizationValidationIsOn) {
  const Buffer a(device(), "a", 64), b(device(), "b", 64);
  const std::string message = error_of(
      [&] {
        run_once(device(), [&](VkCommandBuffer commands) {
          const VkBufferCopy region = {0, 0, 64};
          vkCmdCopyBuffer(commands, a.handle(), b.handle(), 1, &region);
          vkCmdCopyBuffer(commands, b.handle(), a.handle(), 1, &region);  // reads what the first one writes, without waiting
        });
      },
      ExitCode::failure);
  EXPECT_NE(message.find("SYNC-HAZARD"), std::string::npos) << message;
}

}  // namespace
}  // namespace gnomon
