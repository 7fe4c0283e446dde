// WebP pictures (libwebp). Its sides end at 16383, below what other pictures may have.
#include "base/webp.h"

#include <webp/decode.h>

#include <cstring>

#include "base/error.h"

namespace gnomon {

bool is_webp(std::span<const std::byte> encoded) {
  return encoded.size() >= 12 && std::memcmp(encoded.data(), "RIFF", 4) == 0 && std::memcmp(encoded.data() + 8, "WEBP", 4) == 0;
}

Image8 decode_webp(std::span<const std::byte> encoded, const std::string& name) {
  const auto* data = reinterpret_cast<const uint8_t*>(encoded.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, encoded.size(), &features) != VP8_STATUS_OK)
    fail("{}: the WebP picture is damaged in its header", name);
  if (features.has_animation) fail("{}: is an animated WebP; valid: a still one", name);
  // A picture of one colour takes a few dozen bytes whatever its size, but a header alone must not cost a gigabyte.
  constexpr uint64_t k_most_pixels_per_byte = 1u << 16;
  if (static_cast<uint64_t>(features.width) * static_cast<uint64_t>(features.height) >
      k_most_pixels_per_byte * encoded.size()) {
    fail("{}: the picture is damaged ({} x {} pixels cannot be in {} bytes)", name, features.width, features.height,
         encoded.size());
  }
  Image8 image(features.width, features.height);
  if (!WebPDecodeRGBAInto(data, encoded.size(), image.rgba.data(), image.rgba.size(), 4 * features.width))
    fail("{}: the WebP picture is damaged", name);
  return image;
}

}  // namespace gnomon
