// Whole files: read at once, written so that a half-written result never looks whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

// Throws Error (names the path and the system's reason; a Git LFS pointer is no file).
std::vector<std::byte> read_file(const std::filesystem::path& path);
std::string read_text_file(const std::filesystem::path& path);

// Writes beside the target and renames: the old content stays until the new one is complete.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

// Throws what write_file would throw, before the work whose result it is; leaves nothing behind.
void check_can_write(const std::filesystem::path& path);

// Creates the folder and its parents. Throws Error where something else stands in the way.
void make_folder(const std::filesystem::path& path);

// FNV-1a, 64 bit: identifies content, no defence against an adversary.
class ContentHash {
 public:
  void add(std::span<const std::byte> bytes);
  template <class T>
  void add_values(const std::vector<T>& values) {
    add(std::as_bytes(std::span(values)));
  }
  template <class T>
  void add_value(const T& value) {
    add(std::as_bytes(std::span(&value, 1)));
  }
  std::string hex() const;

 private:
  uint64_t state_ = 14695981039346656037ull;
};

}  // namespace gnomon
