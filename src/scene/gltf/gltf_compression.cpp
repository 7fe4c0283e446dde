// Decompression of EXT_meshopt_compression and KHR_draco_mesh_compression.
#include "scene/gltf/gltf_compression.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <exception>

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
  if (f.filter != "NONE" && f.filter != "OCTAHEDRAL" && f.filter != "QUATERNION" && f.filter != "EXPONENTIAL") {
    return fmt::format("filter: is \"{}\"; valid: NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL", f.filter);
  }
  return "";
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
  if (status != 0) return fmt::format("the compressed data is damaged (meshoptimizer says {})", status);
  if (f.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(decoded.data(), f.count, f.stride);
  if (f.filter == "QUATERNION") meshopt_decodeFilterQuat(decoded.data(), f.count, f.stride);
  if (f.filter == "EXPONENTIAL") meshopt_decodeFilterExp(decoded.data(), f.count, f.stride);
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
