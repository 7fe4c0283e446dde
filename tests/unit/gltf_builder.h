// Writes small glTF files for tests: JSON by hand, buffers from vectors.
#pragma once

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/maths.h"
#include "scene/load.h"

namespace gnomon::test_files {

using nlohmann::json;

enum Component { k_byte = 5120, k_ubyte = 5121, k_short = 5122, k_ushort = 5123, k_uint = 5125, k_float = 5126 };

class GltfBuilder {
 public:
  json root = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::byte> data;  // of buffer 0

  // Returns the index of a new buffer view.
  int view(std::span<const std::byte> bytes, int stride = 0) {
    while (data.size() % 4 != 0) data.push_back(std::byte{0});
    json v = {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) v["byteStride"] = stride;
    data.insert(data.end(), bytes.begin(), bytes.end());
    return add("bufferViews", v);
  }

  template <class T>
  int view_of(const std::vector<T>& values, int stride = 0) {
    return view(std::as_bytes(std::span(values)), stride);
  }

  // Returns the index of a new accessor over `values`, which has `count` elements of that type.
  template <class T>
  int accessor(const std::vector<T>& values, const std::string& type, Component component, size_t count,
               bool normalised = false, int stride = 0) {
    json a = {{"bufferView", view_of(values, stride)}, {"componentType", component}, {"type", type}, {"count", count}};
    if (normalised) a["normalized"] = true;
    return add("accessors", a);
  }
  int positions(const std::vector<vec3>& values) { return accessor(values, "VEC3", k_float, values.size()); }
  int uvs(const std::vector<vec2>& values) { return accessor(values, "VEC2", k_float, values.size()); }
  int vec4s(const std::vector<vec4>& values) { return accessor(values, "VEC4", k_float, values.size()); }
  int numbers(const std::vector<float>& values) { return accessor(values, "SCALAR", k_float, values.size()); }
  int matrices(const std::vector<mat4>& values) { return accessor(values, "MAT4", k_float, values.size()); }
  int indices(const std::vector<uint16_t>& values) { return accessor(values, "SCALAR", k_ushort, values.size()); }

  int add(const std::string& array, const json& item) {
    root[array].push_back(item);
    return static_cast<int>(root[array].size()) - 1;
  }
  // A mesh of one primitive; returns its index.
  int mesh(const json& attributes, int index_accessor = -1, const json& more = json::object()) {
    json primitive = {{"attributes", attributes}};
    if (index_accessor >= 0) primitive["indices"] = index_accessor;
    primitive.update(more);
    return add("meshes", {{"primitives", json::array({primitive})}});
  }
  // A node that is a root of scene 0.
  int node(const json& content) {
    const int index = add("nodes", content);
    root["scene"] = 0;
    root["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  // The triangle (0 0 0), (1 0 0), (0 1 0), placed by one node.
  void triangle() { node({{"mesh", mesh({{"POSITION", positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}})}}); }

  std::string gltf() const {
    json document = root;
    if (!data.empty()) document["buffers"][0] = {{"byteLength", data.size()}, {"uri", data_uri(data)}};
    return document.dump();
  }
  std::vector<std::byte> glb() const {
    json document = root;
    if (!data.empty()) document["buffers"][0] = {{"byteLength", data.size()}};
    std::string text = document.dump();
    while (text.size() % 4 != 0) text += ' ';
    std::vector<std::byte> padded = data, bytes;
    while (padded.size() % 4 != 0) padded.push_back(std::byte{0});
    const auto u32 = [&](size_t value) {
      const auto word = static_cast<uint32_t>(value);
      const auto* p = reinterpret_cast<const std::byte*>(&word);
      bytes.insert(bytes.end(), p, p + 4);
    };
    u32(0x46546c67), u32(2), u32(12 + 8 + text.size() + (padded.empty() ? 0 : 8 + padded.size()));
    u32(text.size()), u32(0x4e4f534a);
    const auto characters = std::as_bytes(std::span(text));
    bytes.insert(bytes.end(), characters.begin(), characters.end());
    if (!padded.empty()) {
      u32(padded.size()), u32(0x004e4942);
      bytes.insert(bytes.end(), padded.begin(), padded.end());
    }
    return bytes;
  }
  Scene load(const std::filesystem::path& folder = {}, const SceneFileOptions& options = {}) const {
    return load_text(gltf(), folder, options);
  }
  Scene load(const SceneFileOptions& options) const { return load({}, options); }

  static Scene load_text(const std::string& text, const std::filesystem::path& folder = {},
                         const SceneFileOptions& options = {}) {
    return load_gltf_from_memory(std::as_bytes(std::span(text)), "test.gltf", folder, options);
  }
  // "test.gltf: ...", or "no error".
  std::string error(const SceneFileOptions& options = {}) const {
    try {
      load(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  static std::string data_uri(std::span<const std::byte> bytes, const std::string& type = "application/octet-stream") {
    constexpr const char* k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:" + type + ";base64,";
    for (size_t i = 0; i < bytes.size(); i += 3) {
      uint32_t bits = 0;
      for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint32_t>(bytes[i + k]) : 0u);
      for (size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : k_digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
  }
};

}  // namespace gnomon::test_files
