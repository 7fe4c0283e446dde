// JSON that knows its place in the file, so that every check can name it. glTF is read through this instead of tinygltf: that
// library drops members of the wrong type without a word, refuses what KHR_draco_mesh_compression and EXT_meshopt_compression
// allow (accessors and buffers without data) and decodes Draco data without checking it.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/maths.h"

namespace gnomon {

inline constexpr double k_any = std::numeric_limits<double>::max();

// A view of a value that lives in the document. Every reader checks type and range and throws Error "file: place: ...".
class GltfValue {
 public:
  // `file` must outlive the view.
  GltfValue(const nlohmann::json& value, const std::string& file, std::string place)
      : value_(&value), file_(&file), place_(std::move(place)) {}

  const std::string& place() const { return place_; }
  std::string where(std::string_view key) const {
    return place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key);
  }

  template <class... Args>
  [[noreturn]] void fail_here(fmt::format_string<Args...> format, Args&&... args) const {
    fail_at(place_, fmt::format(format, std::forward<Args>(args)...));
  }
  template <class... Args>
  [[noreturn]] void fail_in(std::string_view key, fmt::format_string<Args...> format, Args&&... args) const {
    fail_at(where(key), fmt::format(format, std::forward<Args>(args)...));
  }

  bool has(std::string_view key) const;
  // Members: an object; the elements of an array of objects (empty where the key is missing); the extension of that name.
  std::optional<GltfValue> object(std::string_view key) const;
  GltfValue required_object(std::string_view key) const;
  std::vector<GltfValue> objects(std::string_view key) const;
  std::optional<GltfValue> extension(std::string_view name) const;
  // Of that array, without the places of its elements, whose text costs more than all else: what asks for each of n others may
  // ask for this, but not for objects().
  size_t count(std::string_view key) const;
  GltfValue element(std::string_view key, size_t index) const;  // an object that is there

  // Numbers within [low, high].
  double number(std::string_view key, double otherwise, double low = -k_any, double high = k_any) const;
  double required_number(std::string_view key, double low, double high) const;
  uint64_t integer(std::string_view key, uint64_t otherwise, uint64_t low, uint64_t high) const;
  uint64_t required_integer(std::string_view key, uint64_t low, uint64_t high) const;
  // The index of one of `count` elements of the array `of` ("accessors"); -1 where the key is missing.
  int index(std::string_view key, size_t count, std::string_view of) const;
  int required_index(std::string_view key, size_t count, std::string_view of) const;
  std::vector<int> indices(std::string_view key, size_t count, std::string_view of) const;
  // Key and index of each member of an object ("attributes").
  std::vector<std::pair<std::string, int>> named_indices(size_t count, std::string_view of) const;

  bool flag(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key, const std::string& otherwise) const;
  std::vector<std::string> texts(std::string_view key) const;
  std::vector<float> floats(std::string_view key) const;
  template <int N>
  glm::vec<N, float> vector(std::string_view key, const glm::vec<N, float>& otherwise) const {
    glm::vec<N, float> result = otherwise;
    read_floats(key, N, &result[0]);
    return result;
  }
  std::optional<mat4> matrix(std::string_view key) const;

 private:
  [[noreturn]] void fail_at(const std::string& place, const std::string& what) const;
  const nlohmann::json* find(std::string_view key) const;
  const nlohmann::json& require(std::string_view key) const;
  const nlohmann::json* find_array(std::string_view key) const;
  int to_index(const nlohmann::json& value, const std::string& place, size_t count, std::string_view of) const;
  double to_number(const nlohmann::json& value, const std::string& place, double low, double high) const;
  uint64_t to_integer(const nlohmann::json& value, const std::string& place, uint64_t low, uint64_t high) const;
  bool read_floats(std::string_view key, size_t count, float* values) const;

  const nlohmann::json* value_;
  const std::string* file_;
  std::string place_;
};

}  // namespace gnomon
