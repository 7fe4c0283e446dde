// Pictures: round trips, and refusal of what is damaged, too large or no picture.
#include "base/image.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "base/error.h"
#include "base/file.h"
#include "base/temporary_folder.h"

namespace gnomon {
namespace {

Image8 gradient(int width, int height) {
  Image8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      uint8_t* texel = image.at(x, y);
      texel[0] = static_cast<uint8_t>(x * 7), texel[1] = static_cast<uint8_t>(y * 11), texel[2] = 99,
      texel[3] = static_cast<uint8_t>(x + y);
    }
  }
  return image;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Image, PngRoundTripKeepsEveryByte) {
  const Image8 image = gradient(33, 17);
  const Image8 back = decode_image(encode_png(image), "memory");
  EXPECT_EQ(back.width, 33);
  EXPECT_EQ(back.height, 17);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Image, FilesRoundTripAndNameThemselvesInErrors) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.png";
  write_png(path, gradient(5, 4));
  EXPECT_EQ(read_image(path).rgba, gradient(5, 4).rgba);
  write_file(path, "no picture at all");
  EXPECT_NE(message_of([&] { read_image(path); }).find(path.string()), std::string::npos);
}

TEST(Image, RefusesDamage) {
  auto encoded = encode_png(gradient(64, 64));
  encoded.resize(encoded.size() / 2);
  EXPECT_NE(message_of([&] { decode_image(encoded, "torn.png"); }).find("torn.png"), std::string::npos);
  EXPECT_NE(message_of([&] { decode_image({}, "empty.png"); }).find("empty.png: not a picture"), std::string::npos);
}

TEST(Image, RefusesSidesAboveTheLimitBeforeDecoding) {
  // The header of a 24-bit BMP of 20000 x 1 pixels.
  const std::array<uint8_t, 54> header = {'B', 'M', 0, 0,    0,    0, 0, 0, 0, 0, 54, 0, 0, 0, 40,
                                          0,   0,   0, 0x20, 0x4e, 0, 0, 1, 0, 0, 0,  1, 0, 24};
  EXPECT_NE(message_of([&] { decode_image(std::as_bytes(std::span(header)), "wide.bmp"); }).find("20000 x 1"),
            std::string::npos);
}

// stb_image itself calls this one "unknown image type": it would take more than 2^30 bytes.
TEST(Image, TooLargeAPngIsToldItsSizeAndTheLimit) {
  auto encoded = encode_png(gradient(4, 4));
  for (const size_t at : {size_t{16}, size_t{20}}) encoded[at + 2] = std::byte{0x4e}, encoded[at + 3] = std::byte{0x20};
  const std::string message = message_of([&] { decode_image(encoded, "huge.png"); });
  EXPECT_NE(message.find("huge.png: 20000 x 20000 pixels; at most 16384"), std::string::npos) << message;
  encoded[16] = std::byte{0xff};
  EXPECT_NE(message_of([&] { decode_image(encoded, "huge.png"); }).find("at most 16384"), std::string::npos);
}

TEST(Image, NamesTheKindThatItDoesNotRead) {
  const std::string ktx("\xabKTX 20\xbb\r\n\x1a\n        ", 20), webp = "RIFF\x24  \x01WEBPVP8 ....";
  EXPECT_NE(message_of([&] { decode_image(std::as_bytes(std::span(ktx)), "a.ktx2"); }).find("(it is KTX2)"), std::string::npos);
  EXPECT_NE(message_of([&] { decode_height_map(std::as_bytes(std::span(webp)), "a.png"); }).find("(it is WebP)"),
            std::string::npos);
  const std::string text = "hello, this is no picture";
  EXPECT_EQ(message_of([&] { decode_image(std::as_bytes(std::span(text)), "a.png"); }).find("it is"), std::string::npos);
}

TEST(Image, HeightMapsKeepTheirPrecision) {
  // A grey PNG of 16 bits and four texels: 0, 1, 32768, 65535.
  const uint8_t encoded[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
                             0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x01, 0x10, 0x00, 0x00, 0x00, 0x00, 0x8c, 0xc7, 0x8c,
                             0x52, 0x00, 0x00, 0x00, 0x14, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x09, 0x00, 0xf6, 0xff,
                             0x00, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0xff, 0xff, 0x05, 0x0b, 0x02, 0x80, 0x73, 0x6a, 0xe7,
                             0xfc, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const ImageF map = decode_height_map(std::as_bytes(std::span(encoded)), "height.png");
  ASSERT_EQ(map.width, 4);
  ASSERT_EQ(map.channels, 1);
  EXPECT_EQ(map.values[0], 0.0f);
  EXPECT_FLOAT_EQ(map.values[1], 1.0f / 65535.0f);
  EXPECT_FLOAT_EQ(map.values[2], 32768.0f / 65535.0f);
  EXPECT_EQ(map.values[3], 1.0f);
}

TEST(Image, ExrIsWrittenWhole) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.exr";
  for (int channels = 1; channels <= 4; ++channels) {
    write_exr(path, ImageF(16, 8, channels));
    const auto bytes = read_file(path);
    ASSERT_GT(bytes.size(), 4u);
    EXPECT_EQ(std::to_integer<int>(bytes[0]), 0x76);  // OpenEXR's magic number
  }
  const auto nowhere = std::filesystem::path("/nonexistent/folder/a.exr");
  EXPECT_NE(message_of([&] { write_exr(nowhere, ImageF(4, 4, 1)); }).find(nowhere.string()), std::string::npos);
}

}  // namespace
}  // namespace gnomon
