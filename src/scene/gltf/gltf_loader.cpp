// glTF 2.0, .gltf and .glb.
#include "base/error.h"
#include "base/file.h"
#include "scene/finish_file_scene.h"
#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_hierarchy.h"
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
  GltfHierarchy hierarchy(document);
  const std::vector<int> shown_nodes = hierarchy.shown_nodes(options.gltf_scene);
  const std::vector<bool> shown = hierarchy.meshes_of(shown_nodes);
  GltfMaterials materials(document, shown, scene);
  std::vector<GltfMesh> meshes = read_gltf_meshes(document, accessors, shown, materials);
  materials.say_what_is_lost();
  add_gltf_nodes(document, accessors, std::move(meshes), options, std::move(hierarchy), shown_nodes, scene);
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
