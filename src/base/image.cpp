// stb for PNG and JPEG, OpenEXR for EXR.
#include "base/image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <unistd.h>

#include <limits>
#include <memory>

#include "base/error.h"
#include "base/file.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

constexpr int k_max_side = 16384;

struct FreePixels {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

const stbi_uc* bytes_of(std::span<const std::byte> encoded) { return reinterpret_cast<const stbi_uc*>(encoded.data()); }

void check_header(std::span<const std::byte> encoded, const std::string& name) {
  if (encoded.size() > static_cast<size_t>(std::numeric_limits<int>::max()))
    fail("{}: {} bytes; valid: below 2 GiB", name, encoded.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels)) {
    fail("{}: not a picture that can be read ({}); valid: PNG, JPEG, TGA, BMP", name, stbi_failure_reason());
  }
  if (width > k_max_side || height > k_max_side) {
    fail("{}: {} x {} pixels; at most {} a side are supported", name, width, height, k_max_side);
  }
  // Deflate packs 1032 bytes of at least eight pixels each into one; nothing else packs more. A header alone must not cost a
  // gigabyte.
  constexpr uint64_t k_most_pixels_per_byte = 8 * 1032;
  if (static_cast<uint64_t>(width) * static_cast<uint64_t>(height) > k_most_pixels_per_byte * encoded.size()) {
    fail("{}: the picture is damaged ({} x {} pixels cannot be in {} bytes)", name, width, height, encoded.size());
  }
}

}  // namespace

Image8 decode_image(std::span<const std::byte> encoded, const std::string& name) {
  check_header(encoded, name);
  Image8 image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      stbi_load_from_memory(bytes_of(encoded), static_cast<int>(encoded.size()), &image.width, &image.height, &channels, 4));
  if (!pixels) fail("{}: the picture is damaged ({})", name, stbi_failure_reason());
  image.rgba.assign(pixels.get(), pixels.get() + static_cast<size_t>(image.width) * image.height * 4);
  return image;
}

ImageF decode_height_map(std::span<const std::byte> encoded, const std::string& name) {
  check_header(encoded, name);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_us, FreePixels> pixels(
      stbi_load_16_from_memory(bytes_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels, 1));
  if (!pixels) fail("{}: the picture is damaged ({})", name, stbi_failure_reason());
  ImageF image(width, height, 1);
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(pixels.get()[i]) / 65535.0f;
  return image;
}

Image8 read_image(const std::filesystem::path& path) { return decode_image(read_file(path), path.string()); }

std::vector<std::byte> encode_png(const Image8& image) {
  std::vector<std::byte> encoded;
  const auto append = [](void* context, void* data, int size) {
    auto& out = *static_cast<std::vector<std::byte>*>(context);
    const auto* bytes = static_cast<const std::byte*>(data);
    out.insert(out.end(), bytes, bytes + size);
  };
  if (!stbi_write_png_to_func(append, &encoded, image.width, image.height, 4, image.rgba.data(), image.width * 4)) {
    fail("a picture of {} x {} pixels could not be encoded as PNG", image.width, image.height);
  }
  return encoded;
}

void write_png(const std::filesystem::path& path, const Image8& image) { write_file(path, encode_png(image)); }

void write_exr(const std::filesystem::path& path, const ImageF& image) {
  static constexpr const char* k_names[5] = {"", "Y", "RG", "RGB", "RGBA"};
  GNOMON_ASSERT(image.channels >= 1 && image.channels <= 4);
  const auto temporary = std::filesystem::path(path.string() + "." + std::to_string(getpid()) + ".part");
  try {
    Imf::Header header(image.width, image.height);
    Imf::FrameBuffer frame_buffer;
    const size_t pixel_stride = sizeof(float) * image.channels;
    for (int c = 0; c < image.channels; ++c) {
      const std::string channel(1, k_names[image.channels][c]);
      header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
      auto* base = reinterpret_cast<char*>(const_cast<float*>(image.values.data() + c));
      frame_buffer.insert(channel, Imf::Slice(Imf::FLOAT, base, pixel_stride, pixel_stride * image.width));
    }
    Imf::OutputFile file(temporary.c_str(), header);
    file.setFrameBuffer(frame_buffer);
    file.writePixels(image.height);
  } catch (const std::exception& error) {
    std::filesystem::remove(temporary);
    fail("{}: the EXR picture cannot be written: {}", path.string(), error.what());
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) fail("{}: writing failed: {}", path.string(), error.message());
}

}  // namespace gnomon
