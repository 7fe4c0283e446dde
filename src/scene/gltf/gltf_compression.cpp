// Decompression of meshopt compression and KHR_draco_mesh_compression.
#include "scene/gltf/gltf_compression.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <exception>
#include <limits>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <draco/compression/decode.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

enum class Mode { attributes, triangles, indices };

// The most that one encoded byte can stand for: a vertex block spends a quarter bit on a repeated byte, a triangle one byte.
uint64_t largest_size(Mode mode, uint64_t encoded_size, uint64_t stride) {
  switch (mode) {
    case Mode::attributes:
      return 64 * encoded_size + 256 * stride;
    case Mode::triangles:
      return 3 * stride * encoded_size;
    case Mode::indices:
      return stride * encoded_size;
  }
  return 0;
}

// What meshoptimizer asserts instead of reporting.
std::string check_meshopt(const MeshoptFormat& f, Mode mode) {
  if (mode == Mode::attributes && (f.stride % 4 != 0 || f.stride > 256))
    return "byteStride of ATTRIBUTES: valid: a multiple of 4 up to 256";
  if (mode != Mode::attributes && f.stride != 2 && f.stride != 4) return "byteStride of indices: valid: 2 or 4";
  if (mode == Mode::triangles && f.count % 3 != 0) return "count of TRIANGLES: valid: a multiple of 3";
  if (mode != Mode::attributes && f.filter != "NONE") return "filter: valid for ATTRIBUTES only";
  if (f.filter == "OCTAHEDRAL" && f.stride != 4 && f.stride != 8) return "byteStride of the filter OCTAHEDRAL: valid: 4 or 8";
  if (f.filter == "QUATERNION" && f.stride != 8) return "byteStride of the filter QUATERNION: valid: 8";
  if (f.filter == "COLOR" && f.stride != 4 && f.stride != 8) return "byteStride of the filter COLOR: valid: 4 or 8";
  constexpr std::array<std::string_view, 5> k_filters = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
  if (std::find(k_filters.begin(), k_filters.end(), f.filter) == k_filters.end())
    return fmt::format("filter: is \"{}\"; valid: {}", f.filter, fmt::join(k_filters, ", "));
  return "";
}

// YCoCg and alpha of K bits to RGBA of all bits; alpha has K-1 bits below a bit that is set. Not in every meshoptimizer.
template <class Signed, class Unsigned>
void decode_colours(std::vector<std::byte>& bytes) {
  for (size_t i = 0; i + 4 * sizeof(Signed) <= bytes.size(); i += 4 * sizeof(Signed)) {
    Signed in[4];
    std::memcpy(in, &bytes[i], sizeof in);
    const uint32_t y = static_cast<Unsigned>(in[0]), alpha = static_cast<Unsigned>(in[3]);
    const uint32_t most = (1u << std::bit_width(alpha)) - 1;
    const int co = in[1], cg = in[2], luma = static_cast<int>(y);
    const uint32_t a = alpha & most >> 1;
    const int rgba[4] = {luma + co - cg, luma + cg, luma - co - cg, static_cast<int>(a << 1 | (a & 1))};
    Unsigned out[4];
    constexpr auto k_most = static_cast<float>(std::numeric_limits<Unsigned>::max());
    for (int c = 0; c < 4; ++c) {
      const float value = most == 0 ? 0.0f : static_cast<float>(rgba[c]) * k_most / static_cast<float>(most);
      out[c] = static_cast<Unsigned>(std::clamp(value + 0.5f, 0.0f, k_most));
    }
    std::memcpy(&bytes[i], out, sizeof out);
  }
}

// Vertex data of KHR_meshopt_compression may come in a later version than the library knows.
std::string damage(Mode mode, const unsigned char* data, size_t size, int status) {
  if (mode == Mode::attributes && size > 0 && (data[0] & 0xf0) == 0xa0 && (data[0] & 0x0f) > 0) {
    return fmt::format(
        "the data is in version {} of the vertex codec, which this meshoptimizer ({}) cannot read; valid: version 0",
        data[0] & 0x0f, MESHOPTIMIZER_VERSION);
  }
  return fmt::format("the compressed data is damaged (meshoptimizer says {})", status);
}

}  // namespace

std::string decode_meshopt(const MeshoptFormat& f, std::span<const std::byte> encoded, std::vector<std::byte>& decoded) {
  Mode mode = Mode::attributes;
  if (f.mode == "TRIANGLES") {
    mode = Mode::triangles;
  } else if (f.mode == "INDICES") {
    mode = Mode::indices;
  } else if (f.mode != "ATTRIBUTES") {
    return fmt::format("mode: is \"{}\"; valid: ATTRIBUTES, TRIANGLES, INDICES", f.mode);
  }
  if (std::string problem = check_meshopt(f, mode); !problem.empty()) return problem;
  if (f.count * f.stride > largest_size(mode, encoded.size(), f.stride)) {
    return fmt::format("count: is {}; {} bytes cannot decode to as many elements", f.count, encoded.size());
  }
  decoded.resize(f.count * f.stride);
  const auto* data = reinterpret_cast<const unsigned char*>(encoded.data());
  int status = 0;
  switch (mode) {
    case Mode::attributes:
      status = meshopt_decodeVertexBuffer(decoded.data(), f.count, f.stride, data, encoded.size());
      break;
    case Mode::triangles:
      status = meshopt_decodeIndexBuffer(decoded.data(), f.count, f.stride, data, encoded.size());
      break;
    case Mode::indices:
      status = meshopt_decodeIndexSequence(decoded.data(), f.count, f.stride, data, encoded.size());
      break;
  }
  if (status != 0) return damage(mode, data, encoded.size(), status);
  if (f.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(decoded.data(), f.count, f.stride);
  if (f.filter == "QUATERNION") meshopt_decodeFilterQuat(decoded.data(), f.count, f.stride);
  if (f.filter == "EXPONENTIAL") meshopt_decodeFilterExp(decoded.data(), f.count, f.stride);
  if (f.filter == "COLOR" && f.stride == 4) decode_colours<int8_t, uint8_t>(decoded);
  if (f.filter == "COLOR" && f.stride == 8) decode_colours<int16_t, uint16_t>(decoded);
  return "";
}

namespace {

std::string read_attribute(const draco::Mesh& mesh, uint32_t id, DracoMesh::Attribute& result) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
  if (!attribute) return fmt::format("the compressed data has no attribute {}", id);
  const int components = attribute->num_components();
  if (components < 1 || components > 4) return fmt::format("attribute {} has {} components; valid: 1 to 4", id, components);
  result.components = components;
  result.normalised = attribute->normalized();
  result.values.resize(static_cast<size_t>(mesh.num_points()) * static_cast<size_t>(components));
  for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex value = attribute->mapped_index(i);
    float* out = &result.values[static_cast<size_t>(i.value()) * static_cast<size_t>(components)];
    if (value.value() >= attribute->size() || !attribute->ConvertValue<float>(value, static_cast<int8_t>(components), out)) {
      return fmt::format("attribute {} has no value for vertex {}", id, i.value());
    }
  }
  return "";
}

}  // namespace

std::string decode_draco(std::span<const std::byte> encoded, const std::map<std::string, uint32_t>& attribute_ids,
                         DracoMesh& result) {
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(encoded.data()), encoded.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) return fmt::format("the compressed data is damaged ({})", decoded.status().error_msg_string());
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    result.vertex_count = mesh->num_points();
    result.indices.reserve(static_cast<size_t>(mesh->num_faces()) * 3);
    for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f) {
      for (int k = 0; k < 3; ++k) result.indices.push_back(mesh->face(f)[static_cast<size_t>(k)].value());
    }
    for (const auto& [name, id] : attribute_ids) {
      if (std::string problem = read_attribute(*mesh, id, result.attributes[name]); !problem.empty()) return problem;
    }
    return "";
  } catch (const std::exception& error) {
    // Damaged counts inside the stream end in bad_alloc or length_error.
    return fmt::format("the compressed data is damaged ({})", error.what());
  }
}

}  // namespace gnomon
