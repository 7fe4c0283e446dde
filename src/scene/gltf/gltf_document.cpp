// The container of a glTF file - JSON alone, or JSON and a binary chunk - and its buffers.
#include "scene/gltf/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/file.h"
#include "base/log.h"
#include "base/percent_encoding.h"
#include "scene/gltf/gltf_compression.h"
#include "scene/gltf/gltf_extensions.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr std::array k_meshopt = {"EXT_meshopt_compression", "KHR_meshopt_compression"};  // draft and ratified name

std::optional<GltfValue> meshopt_extension(const GltfValue& json) {
  for (const char* name : k_meshopt) {
    if (auto extension = json.extension(name)) return extension;
  }
  return std::nullopt;
}

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
  check_required_extensions();
  buffer_json_ = root().objects("buffers");
  buffers_.resize(buffer_json_.size());
  for (const GltfValue& json : buffer_json_) {
    // What is wrong with the text of the document itself is wrong whether or not something reads it.
    if (const std::string uri = json.text("uri", ""); uri.starts_with("data:")) digits_of(uri, json.where("uri"));
  }
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
  if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe")) fail("{}:1: UTF-16 text; valid: UTF-8", name_);
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
  if (!asset.has("version")) asset.fail_in("version", "is missing; valid: \"2.0\"");
  const std::string version = asset.text("version", "");
  if (!version.starts_with("2.")) asset.fail_in("version", "is \"{}\"; valid: \"2.0\"", version);
  const std::string least = asset.text("minVersion", "2.0");
  if (least != "2.0") asset.fail_in("minVersion", "is \"{}\": a later glTF; valid: \"2.0\"", least);
}

void GltfDocument::check_required_extensions() const {
  std::vector<std::string> ignored;
  for (const std::string& extension : root().texts("extensionsRequired")) {
    if (is_read_extension(extension)) continue;
    if (!cannot_change_shape(extension)) {
      root().fail_in("extensionsRequired", "{} is not supported; supported: {}", extension, fmt::join(read_extensions(), ", "));
    }
    ignored.push_back(extension);
  }
  if (!ignored.empty()) {
    log_warning(
        "{}: extensionsRequired: {} is not read; it does not change what stands where: what has no holes casts the right "
        "shadow",
        name_, fmt::join(ignored, ", "));
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

std::string_view GltfDocument::digits_of(std::string_view uri, const std::string& place) const {
  const size_t comma = uri.find(',');
  const std::string_view header = uri.substr(0, comma);
  // data:[type][;name=value]...;base64,
  if (comma == uri.npos || !header.ends_with(";base64") || header.find(";;") != header.npos) {
    fail("{}: {}: is a malformed data URI; valid: data:TYPE;base64,DIGITS", name_, place);
  }
  return uri.substr(comma + 1);
}

std::vector<std::byte> GltfDocument::read_uri(const std::string& uri, const std::string& place) const {
  if (!uri.starts_with("data:")) {
    const auto path = find_file(uri);
    if (!path) fail("{}: {}: {} is not there; valid: a file's path relative to this one, or a data: URI", name_, place, uri);
    return read_file(*path);
  }
  auto bytes = base64_decoded(digits_of(uri, place));
  if (!bytes) fail("{}: {}: holds a character that is not base64", name_, place);
  return std::move(*bytes);
}

GltfDocument::Buffer& GltfDocument::buffer(int index) {
  Buffer& buffer = buffers_[static_cast<size_t>(index)];
  if (buffer.declared > 0) return buffer;
  const GltfValue& json = buffer_json_[static_cast<size_t>(index)];
  buffer.declared = json.required_integer("byteLength", 1, uint64_t{1} << 40);
  const std::string uri = json.text("uri", "");
  std::error_code error;
  if (const auto path = find_file(uri)) {
    if (const auto size = fs::file_size(*path, error); !error) budget_.add_input(size);
  } else {
    budget_.add_input(uri.size());
  }
  return buffer;
}

Bytes GltfDocument::data(int index, const std::string& place) {
  Buffer& known = buffer(index);
  if (known.is_read) return known.bytes;
  const GltfValue& json = buffer_json_[static_cast<size_t>(index)];
  if (json.has("uri")) {
    known.owned = read_uri(json.text("uri", ""), json.where("uri"));
    known.bytes = known.owned;
  } else if (index == 0 && binary_chunk_) {
    known.bytes = *binary_chunk_;
  } else {
    json.fail_in(
        "uri", "is missing, and {} needs its data; valid without: the first buffer of a .glb, fallbacks of compression", place);
  }
  if (known.bytes.size() < known.declared)
    json.fail_in("byteLength", "is {}; the data has only {} bytes", known.declared, known.bytes.size());
  known.is_read = true;
  return known.bytes;
}

void GltfDocument::read_slice(const GltfValue& json, Slice& slice) {
  slice.place = json.place();
  slice.buffer = json.required_index("buffer", buffers_.size(), "buffers");
  const uint64_t size = buffer(slice.buffer).declared;
  slice.length = json.required_integer("byteLength", 1, size);
  slice.offset = json.integer("byteOffset", 0, 0, size - slice.length);
}

void GltfDocument::read_views() {
  for (const GltfValue& json : root().objects("bufferViews")) {
    View view;
    read_slice(json, view);
    view.stride = json.integer("byteStride", 0, 4, 252);
    if (const auto extension = meshopt_extension(json)) view.compressed = read_compressed(*extension, view.length);
    views_.push_back(std::move(view));
  }
}

GltfDocument::Compressed GltfDocument::read_compressed(const GltfValue& json, uint64_t view_length) {
  Compressed result;
  read_slice(json, result);
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

bool GltfDocument::decode(View& view) {
  if (view.is_decoded) return true;
  const Compressed& c = *view.compressed;
  const bool has_data = (c.buffer == 0 && binary_chunk_) || buffer_json_[static_cast<size_t>(c.buffer)].has("uri");
  if (!has_data) fail("{}: {}.buffer: is {}, a fallback without data", name_, c.place, c.buffer);
  const Bytes encoded = data(c.buffer, c.place).subspan(c.offset, c.length);
  const auto problem = decode_meshopt({c.count, c.stride, c.mode, c.filter}, encoded, view.decoded);
  view.is_decoded = problem.empty();
  if (!view.is_decoded && !buffer_json_[static_cast<size_t>(view.buffer)].has("uri"))
    fail("{}: {}: {}", name_, c.place, problem);
  if (!view.is_decoded) log_warning("{}: {}: {}; its uncompressed fallback is read instead", name_, c.place, problem);
  return view.is_decoded;
}

Bytes GltfDocument::view(int index, const std::string& place) {
  View& view = views_[static_cast<size_t>(index)];
  if (view.compressed && decode(view)) return view.decoded;
  return data(view.buffer, place).subspan(view.offset, view.length);
}

}  // namespace gnomon
