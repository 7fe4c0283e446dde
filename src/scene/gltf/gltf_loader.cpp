// glTF 2.0, .gltf and .glb.
#include "base/error.h"
#include "base/file.h"
#include "scene/finish_file_scene.h"
#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_materials.h"
#include "scene/gltf/gltf_meshes.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/load.h"

namespace gnomon {

Scene load_gltf_from_memory(std::span<const std::byte> bytes, const std::string& name, const std::filesystem::path& folder,
                            const SceneFileOptions& options) {
  GltfDocument document(bytes, name, folder);
  Scene scene;
  scene.source = name;
  scene.name = std::filesystem::path(name).filename().string();
  const GltfAccessors accessors(document);
  GltfMaterials materials(document, scene);
  add_gltf_nodes(document, accessors, read_gltf_meshes(document, accessors, materials), options, scene);
  if (scene.materials.empty()) materials.default_material();
  finish_file_scene(scene, options);
  return scene;
}

Scene load_gltf(const std::filesystem::path& path, const SceneFileOptions& options) {
  const std::vector<std::byte> bytes = read_file(path);
  const auto folder = path.parent_path();
  return load_gltf_from_memory(bytes, path.string(), folder.empty() ? "." : folder, options);
}

}  // namespace gnomon
