// Pictures in memory and on disk: PNG, JPEG, WebP, TGA, BMP in; PNG and OpenEXR out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

// 8 bits a channel, four channels (RGBA), rows from top to bottom.
struct Image8 {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;

  Image8() = default;
  Image8(int w, int h) : width(w), height(h), rgba(static_cast<size_t>(w) * h * 4) {}
  uint8_t* at(int x, int y) { return &rgba[(static_cast<size_t>(y) * width + x) * 4]; }
  const uint8_t* at(int x, int y) const { return &rgba[(static_cast<size_t>(y) * width + x) * 4]; }
};

// 32-bit float, any number of interleaved channels, rows from top to bottom.
struct ImageF {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;

  ImageF() = default;
  ImageF(int w, int h, int c) : width(w), height(h), channels(c), values(static_cast<size_t>(w) * h * c) {}
  float* at(int x, int y) { return &values[(static_cast<size_t>(y) * width + x) * channels]; }
  const float* at(int x, int y) const { return &values[(static_cast<size_t>(y) * width + x) * channels]; }
};

// Decodes a file held in memory; `name` is for the error message. Refuses sides above 16384.
Image8 decode_image(std::span<const std::byte> encoded, const std::string& name);
// One channel in [0, 1], at the file's own precision (8 or 16 bits): for height maps.
ImageF decode_height_map(std::span<const std::byte> encoded, const std::string& name);
Image8 read_image(const std::filesystem::path& path);

std::vector<std::byte> encode_png(const Image8& image);
void write_png(const std::filesystem::path& path, const Image8& image);
// Channels are named Y (1), RG (2), RGB (3), RGBA (4); stored as 32-bit float.
void write_exr(const std::filesystem::path& path, const ImageF& image);

}  // namespace gnomon
