// The container of a glTF file - JSON alone, or JSON and a binary chunk - and its buffers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/file_finder.h"
#include "scene/gltf/gltf_json.h"

namespace gnomon {

using Bytes = std::span<const std::byte>;

// What is decoded may be larger than the file (compression, vertices shared by many primitives), but not without limit: a
// small file must not ask for gigabytes.
class GltfBudget {
 public:
  explicit GltfBudget(const std::string& file) : file_(file) {}
  void add_input(size_t bytes) { left_ += 64 * bytes; }
  // Takes `elements` of up to 64 bytes each.
  void take(uint64_t elements, const std::string& place);

 private:
  const std::string& file_;
  uint64_t left_ = 1u << 20;
};

class GltfDocument {
 public:
  // `bytes` must outlive the document. Refuses what is damaged as a container, and required extensions that may change what
  // stands where and are not read. Buffers are read when something needs them: others may be missing or too short.
  GltfDocument(Bytes bytes, const std::string& name, const std::filesystem::path& folder);

  GltfValue root() const { return GltfValue(json_, name_, ""); }
  const std::string& name() const { return name_; }
  const std::filesystem::path& folder() const { return folder_; }
  GltfBudget& budget() { return budget_; }

  size_t view_count() const { return views_.size(); }
  // The bytes of a buffer view, decompressed where meshopt compression says so. `place`: who asks.
  Bytes view(int index, const std::string& place);
  uint64_t view_length(int index) const { return views_[static_cast<size_t>(index)].length; }
  size_t view_stride(int index) const { return views_[static_cast<size_t>(index)].stride; }  // 0: packed

  // A data: or relative URI. `place`: the JSON place for errors. nullopt where a file is missing and that is allowed.
  std::vector<std::byte> read_uri(const std::string& uri, const std::string& place) const;
  // Where a relative URI points, or nullopt for data URIs and where no file is there.
  std::optional<std::filesystem::path> find_file(const std::string& uri) const;

 private:
  struct Buffer {
    uint64_t declared = 0;  // bytes; 0: no view has named it yet
    bool is_read = false;
    std::vector<std::byte> owned;
    Bytes bytes;
  };
  struct Slice {  // of a buffer
    int buffer = 0;
    uint64_t offset = 0, length = 0;
    std::string place;
  };
  struct Compressed : Slice {
    uint64_t stride = 0, count = 0;
    std::string mode, filter;
  };
  struct View : Slice {
    size_t stride = 0;
    std::optional<Compressed> compressed;
    std::vector<std::byte> decoded;
    bool is_decoded = false;
  };

  std::string_view digits_of(std::string_view data_uri, const std::string& place) const;
  void split_binary(Bytes bytes);
  void parse_json(std::string_view text, size_t offset);
  void check_asset() const;
  void check_required_extensions() const;
  Buffer& buffer(int index);
  Bytes data(int buffer, const std::string& place);
  void read_slice(const GltfValue& json, Slice& slice);
  void read_views();
  Compressed read_compressed(const GltfValue& json, uint64_t view_length);
  // False where the compressed data cannot be read but an uncompressed fallback is there.
  bool decode(View& view);

  std::string name_;
  std::filesystem::path folder_;
  mutable FileFinder finder_;  // remembers what it guessed
  GltfBudget budget_;
  nlohmann::json json_;
  std::optional<Bytes> binary_chunk_;
  std::vector<GltfValue> buffer_json_;
  std::vector<Buffer> buffers_;
  std::vector<View> views_;
};

}  // namespace gnomon
