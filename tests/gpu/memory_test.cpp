// Buffers, images, uploads, readback, and what happens when there is too little of any of it.
#include <numeric>
#include <random>

#include "support/device_tests.h"

namespace gnomon {
namespace {

using test::device;
using test::error_of;

std::vector<uint32_t> noise(size_t count) {
  std::vector<uint32_t> values(count);
  std::mt19937 random(7);
  for (uint32_t& value : values) value = static_cast<uint32_t>(random());
  return values;
}

TEST(Memory, BufferComesBackAsItWasSent) {
  for (const size_t count : {size_t{1}, size_t{3}, size_t{1000}, size_t{100003}}) {
    const auto values = noise(count);
    const Buffer buffer(device(), "round trip", count * 4);
    EXPECT_NE(buffer.address(), 0u);
    upload(device(), buffer, std::as_bytes(std::span(values)));
    EXPECT_EQ(read_back_as<uint32_t>(device(), buffer, count), values);
  }
}

TEST(Memory, UploadsOfMoreThan64MiBGoInPieces) {
  // One word more than a piece: the last copy is as small as it can be.
  const auto values = noise((size_t{64} << 20) / 4 + 1);
  const Buffer buffer(device(), "large", values.size() * 4);
  upload(device(), buffer, std::as_bytes(std::span(values)));
  EXPECT_EQ(read_back_as<uint32_t>(device(), buffer, values.size()), values);
}

TEST(Memory, MappedBuffersAreSeenByTheGpuAndBack) {
  const Buffer from(device(), "from", 4096, BufferMemory::upload), to(device(), "to", 4096, BufferMemory::readback);
  const auto values = from.mapped_as<uint32_t>();
  std::iota(values.begin(), values.end(), 5u);
  from.flush();
  test::run_passes([&](Recorder& recorder) {
    recorder.pass("copy", PassStage::other, {{from, Use::copy_read}, {to, Use::copy_write}},
                  [&](Commands& commands) { commands.copy(from, to, 4096); });
  });
  to.invalidate();
  EXPECT_EQ(to.mapped_as<uint32_t>()[0], 5u);
  EXPECT_EQ(to.mapped_as<uint32_t>()[1023], 5u + 1023u);
}

void copy_image(VkCommandBuffer commands, const Image& image, const Buffer& buffer, uint32_t layer, bool to_image) {
  VkBufferImageCopy region = {};
  region.imageSubresource = {image.aspect(), 0, layer, 1};
  region.imageExtent = {image.info().width, image.info().height, 1};
  if (to_image) {
    vkCmdCopyBufferToImage(commands, buffer.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  } else {
    vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle(), 1, &region);
  }
}

TEST(Memory, ImageComesBackAsItWasSent) {
  ImageInfo info;
  info.name = "round trip";
  info.width = 37, info.height = 19, info.layers = 3;
  info.format = VK_FORMAT_R32_UINT;
  info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  const Image image(device(), info);
  const auto values = noise(37 * 19);
  const Buffer in(device(), "in", values.size() * 4), out(device(), "out", values.size() * 4);
  upload(device(), in, std::as_bytes(std::span(values)));
  test::run_passes([&](Recorder& recorder) {
    recorder.pass("in", PassStage::other, {{in, Use::copy_read}, {image, Use::copy_write}},
                  [&](Commands& commands) { copy_image(commands.handle(), image, in, 2, true); });
    recorder.pass("out", PassStage::other, {{image, Use::copy_read}, {out, Use::copy_write}},
                  [&](Commands& commands) { copy_image(commands.handle(), image, out, 2, false); });
  });
  EXPECT_EQ(read_back_as<uint32_t>(device(), out, values.size()), values);
}

TEST(Memory, AllocatedBytesReturnToWhatTheyWere) {
  const uint64_t before = device().allocated_bytes();
  {
    Buffer a(device(), "a", 1000);
    EXPECT_EQ(device().allocated_bytes(), before + 1000);
    Buffer b = std::move(a);
    EXPECT_FALSE(a);  // NOLINT(bugprone-use-after-move): moved-from values are empty by contract
    b = Buffer(device(), "c", 2000);
    EXPECT_EQ(device().allocated_bytes(), before + 2000);
    const Image image(device(), {.name = "image", .width = 16, .height = 16});
    EXPECT_GE(device().allocated_bytes(), before + 2000 + 16 * 16 * 4);
  }
  EXPECT_EQ(device().allocated_bytes(), before);
}

TEST(Memory, TooLargeABufferIsAnError) {
  const uint64_t before = device().allocated_bytes();
  const std::string message = error_of([] { Buffer(device(), "everything", size_t{1} << 44); }, ExitCode::failure);
  EXPECT_NE(message.find("everything"), std::string::npos) << message;
  EXPECT_EQ(device().allocated_bytes(), before);
}

TEST(Memory, TooLargeAnImageIsAnError) {
  const uint64_t before = device().allocated_bytes();
  ImageInfo info;
  info.name = "wall";
  info.width = info.height = 1u << 20;
  const std::string size = error_of([&] { Image(device(), info); }, ExitCode::device);
  EXPECT_NE(size.find("wall"), std::string::npos) << size;
  EXPECT_NE(size.find("limit"), std::string::npos) << size;
  // Within the limits of each side, beyond every memory: 1 GiB a layer.
  info.width = info.height = 16384;
  info.layers = 2048;
  info.format = VK_FORMAT_D32_SFLOAT;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  try {
    const Image image(device(), info);
    ADD_FAILURE() << "2 TiB were given out";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("wall"), std::string::npos) << error.what();
  }
  EXPECT_EQ(device().allocated_bytes(), before);
}

TEST(Memory, UnusableFormatIsAnErrorThatNamesTheImage) {
  ImageInfo info;
  info.name = "odd";
  info.format = VK_FORMAT_R8G8B8_SSCALED;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  const std::string message = error_of([&] { Image(device(), info); }, ExitCode::device);
  EXPECT_NE(message.find("'odd'"), std::string::npos) << message;
}

TEST(Memory, BindlessIndicesAreUsedAgain) {
  ImageInfo info;
  info.name = "passing";
  uint32_t highest = 0;
  for (int i = 0; i < 300; ++i) {
    const Image image(device(), info);
    highest = std::max(highest, image.sampled());
    device().wait_idle();
  }
  const Image first(device(), info), second(device(), info);
  EXPECT_NE(first.sampled(), second.sampled());
  EXPECT_LE(highest, first.sampled() + 2);
}

TEST(Memory, MoreImagesThanTheSetHoldsIsAnErrorAndLeaksNothing) {
  const uint64_t before = device().allocated_bytes();
  ImageInfo info;
  info.name = "one of many";
  info.usage = VK_IMAGE_USAGE_STORAGE_BIT;
  std::vector<Image> images;
  const std::string message = error_of(
      [&] {
        for (uint32_t i = 0; i <= Bindless::k_max_storage_images; ++i) images.emplace_back(device(), info);
      },
      ExitCode::failure);
  EXPECT_NE(message.find(std::to_string(Bindless::k_max_storage_images)), std::string::npos) << message;
  EXPECT_EQ(images.size(), Bindless::k_max_storage_images);
  images.clear();
  device().wait_idle();
  EXPECT_EQ(device().allocated_bytes(), before);
  const Image again(device(), info);
  EXPECT_LT(again.storage(), Bindless::k_max_storage_images);
}

}  // namespace
}  // namespace gnomon
