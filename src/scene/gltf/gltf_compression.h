// Decompression of EXT_ and KHR_meshopt_compression and of KHR_draco_mesh_compression; knows nothing of JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct MeshoptFormat {
  uint64_t count = 0, stride = 0;
  std::string_view mode, filter;
};

// Decodes count * stride bytes. Returns what is wrong, empty for success; allocates no more than the data can decode to.
std::string decode_meshopt(const MeshoptFormat& format, std::span<const std::byte> encoded, std::vector<std::byte>& decoded);

struct DracoMesh {
  struct Attribute {
    int components = 0;
    bool normalised = false;    // integers are scaled to [0, 1] or [-1, 1] already
    std::vector<float> values;  // components of vertex 0, of vertex 1, ...
  };
  size_t vertex_count = 0;
  std::vector<uint32_t> indices;
  std::map<std::string, Attribute> attributes;
};

// `attribute_ids`: which unique id of the stream is which attribute. Returns what is wrong, empty for success.
std::string decode_draco(std::span<const std::byte> encoded, const std::map<std::string, uint32_t>& attribute_ids,
                         DracoMesh& result);

}  // namespace gnomon
