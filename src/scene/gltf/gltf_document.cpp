// The container of a glTF file - JSON alone, or JSON and a binary chunk - and its buffers.
#include "scene/gltf/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/file.h"
#include "base/percent_encoding.h"
#include "scene/gltf/gltf_compression.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr std::array k_supported_extensions = {
    "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",         "KHR_draco_mesh_compression",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_unlit",     "KHR_mesh_quantization",           "KHR_texture_transform",
};

uint32_t read_u32(Bytes bytes, size_t offset) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + offset, 4);
  return value;
}

std::string_view as_text(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// RFC 4648, with or without padding at the end; nullopt where another character occurs.
std::optional<std::vector<std::byte>> base64_decoded(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::byte> result;
  result.reserve(text.size() / 4 * 3 + 2);
  uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const size_t digit = k_digits.find(c);
    if (digit == k_digits.npos) return std::nullopt;
    bits = bits << 6 | static_cast<uint32_t>(digit);
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      result.push_back(static_cast<std::byte>(bits >> bit_count & 0xff));
    }
  }
  return result;
}

}  // namespace

void GltfBudget::take(uint64_t elements, const std::string& place) {
  if (elements > left_) {
    fail("{}: {}: asks for {} elements, far more than a file of this size can hold; valid: counts that fit the data", file_,
         place, elements);
  }
  left_ -= elements;
}

GltfDocument::GltfDocument(Bytes bytes, const std::string& name, const fs::path& folder)
    : name_(name), folder_(folder), finder_(name), budget_(name_) {
  budget_.add_input(bytes.size());
  if (as_text(bytes).starts_with("glTF")) {
    split_binary(bytes);
  } else {
    parse_json(as_text(bytes), 0);
  }
  check_asset();
  read_buffers();
  read_views();
}

// --- container -------------------------------------------------------------------------------------------------------

void GltfDocument::split_binary(Bytes bytes) {
  constexpr uint32_t k_json = 0x4e4f534a, k_bin = 0x004e4942;
  if (bytes.size() < 20) fail("{}: header: {} bytes; valid: at least 20", name_, bytes.size());
  if (read_u32(bytes, 4) != 2) fail("{}: header.version: is {}; valid: 2", name_, read_u32(bytes, 4));
  if (read_u32(bytes, 8) != bytes.size()) {
    fail("{}: header.length: is {}; valid: the size of the file, {}", name_, read_u32(bytes, 8), bytes.size());
  }
  bool has_json = false;
  for (size_t offset = 12, chunk = 0; offset < bytes.size(); ++chunk) {
    if (bytes.size() - offset < 8) fail("{}: chunks[{}]: cut off in its header", name_, chunk);
    const size_t length = read_u32(bytes, offset), left = bytes.size() - offset - 8;
    const uint32_t type = read_u32(bytes, offset + 4);
    if (length > left)
      fail("{}: chunks[{}].length: is {}; valid: at most {}, what is left of the file", name_, chunk, length, left);
    const Bytes content = bytes.subspan(offset + 8, length);
    if (chunk == 0 && type != k_json) fail("{}: chunks[0].type: is {:#x}; valid: JSON ({:#x})", name_, type, k_json);
    if (chunk == 0) {
      parse_json(as_text(content), offset + 8);
      has_json = true;
    } else if (type == k_bin && !binary_chunk_) {
      binary_chunk_ = content;
    }
    offset += 8 + length;
  }
  GNOMON_ASSERT(has_json);
}

void GltfDocument::parse_json(std::string_view text, size_t offset) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  try {
    json_ = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<ptrdiff_t>(at), '\n');
    fail("{}:{}: byte {}: neither JSON nor a binary glTF file: {}", name_, line, offset + at, error.what());
  } catch (const nlohmann::json::exception& error) {
    fail("{}: JSON: holds a number that no variable can hold: {}", name_, error.what());  // 1e999; it tells no place
  }
  if (!json_.is_object()) fail("{}: top level: is {}; valid: an object", name_, json_.type_name());
}

void GltfDocument::check_asset() const {
  const GltfValue asset = root().required_object("asset");
  const std::string version = asset.text("version", "");
  if (!version.starts_with("2.")) asset.fail_in("version", "is \"{}\"; valid: \"2.0\"", version);
  for (const std::string& extension : root().texts("extensionsRequired")) {
    if (std::find(k_supported_extensions.begin(), k_supported_extensions.end(), extension) != k_supported_extensions.end())
      continue;
    root().fail_in("extensionsRequired", "{} is not supported; supported: {}", extension,
                   fmt::join(k_supported_extensions, ", "));
  }
}

// --- buffers ---------------------------------------------------------------------------------------------------------

std::optional<fs::path> GltfDocument::find_file(const std::string& uri) const {
  if (folder_.empty() || uri.starts_with("data:")) return std::nullopt;
  const std::span<const fs::path> folders(&folder_, 1);
  const std::string decoded = percent_decoded(uri);
  for (const std::string& spelling : {decoded, uri}) {  // some exporters do not escape
    if (const auto exact = finder_.find_exactly(spelling, folders)) return exact;
  }
  return finder_.find(decoded, folders);
}

std::vector<std::byte> GltfDocument::read_uri(const std::string& uri, const std::string& place) const {
  if (!uri.starts_with("data:")) {
    const auto path = find_file(uri);
    if (!path) fail("{}: {}: {} is not there; valid: a file's path relative to this one, or a data: URI", name_, place, uri);
    return read_file(*path);
  }
  const size_t comma = uri.find(',');
  const std::string_view header = std::string_view(uri).substr(0, comma);
  // data:[type][;name=value]...;base64,
  if (comma == uri.npos || !header.ends_with(";base64") || header.find(";;") != header.npos) {
    fail("{}: {}: is a malformed data URI; valid: data:TYPE;base64,DIGITS", name_, place);
  }
  auto bytes = base64_decoded(std::string_view(uri).substr(comma + 1));
  if (!bytes) fail("{}: {}: holds a character that is not base64", name_, place);
  return std::move(*bytes);
}

void GltfDocument::read_buffers() {
  for (const GltfValue& json : root().objects("buffers")) {
    Buffer buffer;
    buffer.declared = json.required_integer("byteLength", 1, uint64_t{1} << 40);
    const auto fallback = json.extension("EXT_meshopt_compression");
    if (json.has("uri")) {
      buffer.owned = read_uri(json.text("uri", ""), json.where("uri"));
      buffer.bytes = buffer.owned;
      budget_.add_input(buffer.owned.size());
      buffer.has_data = true;
    } else if (buffers_.empty() && binary_chunk_) {
      buffer.bytes = *binary_chunk_;
      buffer.has_data = true;
    } else if (!fallback || !fallback->flag("fallback", false)) {
      json.fail_in("uri",
                   "is missing; only the first buffer of a .glb and a fallback of EXT_meshopt_compression may be without");
    }
    if (buffer.has_data && buffer.bytes.size() < buffer.declared) {
      json.fail_in("byteLength", "is {}; the data has only {} bytes", buffer.declared, buffer.bytes.size());
    }
    buffers_.push_back(std::move(buffer));
  }
}

void GltfDocument::read_views() {
  for (const GltfValue& json : root().objects("bufferViews")) {
    View view;
    view.place = json.place();
    view.buffer = json.required_index("buffer", buffers_.size(), "buffers");
    const uint64_t size = buffers_[static_cast<size_t>(view.buffer)].declared;
    view.length = json.required_integer("byteLength", 1, size);
    view.offset = json.integer("byteOffset", 0, 0, size - view.length);
    view.stride = json.integer("byteStride", 0, 4, 252);
    if (const auto extension = json.extension("EXT_meshopt_compression"))
      view.compressed = read_compressed(*extension, view.length);
    views_.push_back(std::move(view));
  }
}

GltfDocument::Compressed GltfDocument::read_compressed(const GltfValue& json, uint64_t view_length) const {
  Compressed result;
  result.place = json.place();
  result.buffer = json.required_index("buffer", buffers_.size(), "buffers");
  const Buffer& buffer = buffers_[static_cast<size_t>(result.buffer)];
  if (!buffer.has_data) json.fail_in("buffer", "{} is a fallback without data", result.buffer);
  result.length = json.required_integer("byteLength", 1, buffer.bytes.size());
  result.offset = json.integer("byteOffset", 0, 0, buffer.bytes.size() - result.length);
  result.stride = json.required_integer("byteStride", 1, 256);
  result.count = json.required_integer("count", 1, uint64_t{1} << 32);
  result.mode = json.text("mode", "");
  result.filter = json.text("filter", "NONE");
  if (result.count * result.stride > view_length) {
    json.fail_in("count", "{} elements of {} bytes are more than the {} bytes of the buffer view", result.count, result.stride,
                 view_length);
  }
  return result;
}

void GltfDocument::decode(View& view) {
  const Compressed& c = *view.compressed;
  const Bytes encoded = buffers_[static_cast<size_t>(c.buffer)].bytes.subspan(c.offset, c.length);
  const auto problem = decode_meshopt({c.count, c.stride, c.mode, c.filter}, encoded, view.decoded);
  if (!problem.empty()) fail("{}: {}: {}", name_, c.place, problem);
  view.is_decoded = true;
}

Bytes GltfDocument::view(int index, const std::string& place) {
  View& view = views_[static_cast<size_t>(index)];
  if (view.compressed) {
    if (!view.is_decoded) decode(view);
    return view.decoded;
  }
  const Buffer& buffer = buffers_[static_cast<size_t>(view.buffer)];
  if (!buffer.has_data) fail("{}: {}: uses {}, whose buffer is a fallback without data", name_, place, view.place);
  return buffer.bytes.subspan(view.offset, view.length);
}

}  // namespace gnomon
