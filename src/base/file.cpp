// Whole files.
#include "base/file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/error.h"
#include "base/interrupt.h"

namespace gnomon {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// What a clone without Git LFS has in place of each large file. No file that is read here is one, whatever its type.
void refuse_lfs_pointer(std::span<const std::byte> bytes, const std::filesystem::path& path) {
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 64));
  if (start.starts_with("version https://git-lfs.github.com/spec/"))
    fail("{}: is a Git LFS pointer, not the file itself; 'git lfs pull' in its folder fetches the file", path.string());
}

}  // namespace

std::vector<std::byte> read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) fail("{}: is a folder, not a file", path.string());
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail("{}: cannot be read: {}", path.string(), std::strerror(errno));
  std::vector<std::byte> bytes;
  std::error_code no_size;
  const auto size = std::filesystem::file_size(path, no_size);
  if (!no_size) bytes.reserve(size);
  std::byte chunk[1 << 16];
  for (size_t count; (count = std::fread(chunk, 1, sizeof chunk, file.get())) > 0;) {
    bytes.insert(bytes.end(), chunk, chunk + count);
    check_cancelled();
  }
  if (std::ferror(file.get())) fail("{}: reading failed: {}", path.string(), std::strerror(errno));
  refuse_lfs_pointer(bytes, path);
  return bytes;
}

std::string read_text_file(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const auto temporary = std::filesystem::path(path.string() + "." + std::to_string(getpid()) + ".part");
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) fail("{}: cannot be written: {}", path.string(), std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const bool closed = std::fclose(file.release()) == 0;
  std::error_code error;
  if (written && closed) std::filesystem::rename(temporary, path, error);
  if (!written || !closed || error) {
    const std::string reason = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(temporary, error);
    fail("{}: writing failed: {}", path.string(), reason);
  }
}

void write_file(const std::filesystem::path& path, std::string_view text) { write_file(path, std::as_bytes(std::span(text))); }

void check_can_write(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) fail("{}: cannot be written: it is a folder", path.string());
  const auto temporary = std::filesystem::path(path.string() + "." + std::to_string(getpid()) + ".part");
  const File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) fail("{}: cannot be written: {}", path.string(), std::strerror(errno));
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    fail("{}: the folder cannot be made: {}", path.string(), error ? error.message() : "a file of that name exists");
  }
}

void ContentHash::add(std::span<const std::byte> bytes) {
  // Eight bytes a step: hashing a large scene must not be felt.
  size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    state_ = (state_ ^ word) * 1099511628211ull;
    state_ ^= state_ >> 29;
  }
  for (; i < bytes.size(); ++i) state_ = (state_ ^ static_cast<uint64_t>(bytes[i])) * 1099511628211ull;
}

std::string ContentHash::hex() const { return fmt::format("{:016x}", state_); }

}  // namespace gnomon
