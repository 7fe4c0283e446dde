// Which extensions of glTF a file may require.
#include "scene/gltf/gltf_extensions.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

constexpr std::array<std::string_view, 12> k_read = {"EXT_mesh_gpu_instancing",
                                                     "EXT_meshopt_compression",
                                                     "EXT_texture_webp",
                                                     "KHR_draco_mesh_compression",
                                                     "KHR_lights_punctual",
                                                     "KHR_materials_emissive_strength",
                                                     "KHR_materials_pbrSpecularGlossiness",
                                                     "KHR_materials_unlit",
                                                     "KHR_mesh_quantization",
                                                     "KHR_meshopt_compression",
                                                     "KHR_node_visibility",
                                                     "KHR_texture_transform"};

// After the vendor's prefix.
constexpr std::array<std::string_view, 12> k_looks = {"audio",
                                                      "interactivity",
                                                      "lights",
                                                      "materials",
                                                      "mesh_features",
                                                      "mesh_manifold",
                                                      "physics",
                                                      "primitive_outline",
                                                      "structural_metadata",
                                                      "techniques_webgl",
                                                      "texture",
                                                      "xmp"};

}  // namespace

std::span<const std::string_view> read_extensions() { return k_read; }

bool is_read_extension(std::string_view name) { return std::find(k_read.begin(), k_read.end(), name) != k_read.end(); }

bool cannot_change_shape(std::string_view name) {
  const size_t prefix = name.find('_');
  if (prefix == name.npos) return false;
  const std::string_view rest = name.substr(prefix + 1);
  return std::any_of(k_looks.begin(), k_looks.end(), [&](std::string_view word) { return rest.starts_with(word); });
}

}  // namespace gnomon
