// Base64 (RFC 4648) and the store.
#include "report/pictures.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/error.h"
#include "base/file.h"

namespace gnomon {

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char k_alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? std::to_integer<uint32_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += k <= count ? k_alphabet[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

size_t PictureStore::add(const std::filesystem::path& path, const std::string& where) {
  const auto key = path.lexically_normal();
  if (const auto known = by_path_.find(key); known != by_path_.end()) return known->second;
  std::vector<std::byte> bytes;
  try {
    bytes = read_file(path);
  } catch (const Error& error) {
    fail("{}: picture {}", where, error.what());
  }
  static constexpr std::array<unsigned char, 8> k_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  const auto same = [](std::byte a, unsigned char b) { return std::to_integer<unsigned char>(a) == b; };
  if (bytes.size() < k_signature.size() || !std::equal(k_signature.begin(), k_signature.end(), bytes.begin(),
                                                       [&](unsigned char b, std::byte a) { return same(a, b); })) {
    fail("{}: picture {} is not a PNG", where, path.string());
  }

  uris_.push_back("data:image/png;base64," + base64(bytes));
  const auto [found, is_new] = by_content_.try_emplace(uris_.back(), uris_.size() - 1);
  if (!is_new) uris_.pop_back();
  return by_path_[key] = found->second;
}

nlohmann::json PictureStore::replace_names(const nlohmann::json& images, const std::filesystem::path& folder,
                                           const std::string& where) {
  if (images.is_string()) return add(folder / images.get<std::string>(), where);
  nlohmann::json replaced = images;
  for (auto& item : replaced) item = replace_names(item, folder, where);
  return replaced;
}

}  // namespace gnomon
