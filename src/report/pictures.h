// PNG files -> data URIs, each picture once: all rows of a scene share their reference pictures.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace gnomon {

std::string base64(std::span<const std::byte> bytes);

class PictureStore {
 public:
  // The picture's index; equal content gets equal indices, whatever the files are called. `where` names the line that
  // asks for it in errors: not readable, not a PNG.
  size_t add(const std::filesystem::path& path, const std::string& where);

  // The nested object `images` of a line with indices in place of names; relative to `folder`.
  nlohmann::json replace_names(const nlohmann::json& images, const std::filesystem::path& folder, const std::string& where);

  const std::deque<std::string>& data_uris() const { return uris_; }

 private:
  std::deque<std::string> uris_;  // a deque: the views below stay valid
  std::unordered_map<std::string_view, size_t> by_content_;
  std::map<std::filesystem::path, size_t> by_path_;
};

}  // namespace gnomon
