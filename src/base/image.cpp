// stb for PNG and JPEG, OpenEXR for EXR.
#include "base/image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/webp.h"

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
constexpr std::string_view k_valid = "valid: PNG, JPEG, WebP, TGA, BMP";

struct FreePixels {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

const stbi_uc* bytes_of(std::span<const std::byte> encoded) { return reinterpret_cast<const stbi_uc*>(encoded.data()); }

// By the first bytes, for who named a picture of a kind that is not read here.
std::string_view format_name(std::span<const std::byte> encoded) {
  const std::string_view start(reinterpret_cast<const char*>(encoded.data()), std::min<size_t>(encoded.size(), 16));
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, std::string_view> k_formats[] = {{"\xabKTX 20"sv, "KTX2"},
                                                                         {"\xabKTX 11"sv, "KTX"},
                                                                         {"DDS "sv, "DDS"},
                                                                         {"II*\0"sv, "TIFF"},
                                                                         {"MM\0*"sv, "TIFF"},
                                                                         {"v/1\x01"sv, "OpenEXR"},
                                                                         {"\0\0\0\x0cjP"sv, "JPEG 2000"},
                                                                         {"\xff\x0a"sv, "JPEG XL"},
                                                                         {"<svg"sv, "SVG"}};
  if (start.starts_with("RIFF") && start.substr(std::min<size_t>(8, start.size())).starts_with("WEBP")) return "WebP";
  if (start.size() > 8 && start.substr(4).starts_with("ftypavif")) return "AVIF";
  for (const auto& [magic, name] : k_formats) {
    if (start.starts_with(magic)) return name;
  }
  return {};
}

struct Size {
  uint32_t width = 0, height = 0;
};

// stb_image calls a PNG of more than 2^30 bytes no picture at all. Its size stands at the same place in every PNG.
std::optional<Size> png_size(std::span<const std::byte> encoded) {
  constexpr std::string_view k_magic = "\x89PNG\r\n\x1a\n";
  const std::string_view text(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  if (!text.starts_with(k_magic) || text.size() < 24 || text.substr(12, 4) != "IHDR") return std::nullopt;
  const auto number = [&](size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<uint32_t>(encoded[at + i]);
    return value;
  };
  return Size{number(16), number(20)};
}

void check_sides(uint64_t width, uint64_t height, const std::string& name) {
  if (width > k_max_side || height > k_max_side)
    fail("{}: {} x {} pixels; at most {} a side are supported", name, width, height, k_max_side);
}

void check_header(std::span<const std::byte> encoded, const std::string& name) {
  if (encoded.empty()) fail("{}: not a picture that can be read (it is empty); {}", name, k_valid);
  if (encoded.size() > static_cast<size_t>(std::numeric_limits<int>::max()))
    fail("{}: {} bytes; valid: below 2 GiB", name, encoded.size());
  if (const auto size = png_size(encoded)) check_sides(size->width, size->height, name);
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels)) {
    const std::string_view format = format_name(encoded);
    const std::string reason = format.empty() ? stbi_failure_reason() : fmt::format("it is {}", format);
    fail("{}: not a picture that can be read ({}); {}", name, reason, k_valid);
  }
  check_sides(static_cast<uint64_t>(width), static_cast<uint64_t>(height), name);
  // Deflate packs 1032 bytes of at least eight pixels each into one; nothing else packs more. A header alone must not cost a
  // gigabyte.
  constexpr uint64_t k_most_pixels_per_byte = 8 * 1032;
  if (static_cast<uint64_t>(width) * static_cast<uint64_t>(height) > k_most_pixels_per_byte * encoded.size()) {
    fail("{}: the picture is damaged ({} x {} pixels cannot be in {} bytes)", name, width, height, encoded.size());
  }
}

}  // namespace

Image8 decode_image(std::span<const std::byte> encoded, const std::string& name) {
  if (is_webp(encoded)) return decode_webp(encoded, name);
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
