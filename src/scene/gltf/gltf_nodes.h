// The nodes of a glTF file: placed meshes, instances, lights and cameras.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_hierarchy.h"
#include "scene/gltf/gltf_meshes.h"
#include "scene/load.h"

namespace gnomon {

// Adds objects, the meshes that they need, lights and cameras of the shown nodes, as the chosen animation has them. Instances
// and nodes of the same shape share their mesh.
void add_gltf_nodes(GltfDocument& document, const GltfAccessors& accessors, std::vector<GltfMesh> meshes,
                    const SceneFileOptions& options, GltfHierarchy hierarchy, const std::vector<int>& shown, Scene& scene);

}  // namespace gnomon
