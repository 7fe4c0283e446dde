// The node hierarchy of a glTF file: placed meshes, instances, lights and cameras.
#pragma once

#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/scene.h"

namespace gnomon {

// Adds objects, the meshes that they need, lights and cameras to the scene. Instances share their mesh.
void add_gltf_nodes(const GltfDocument& document, const GltfAccessors& accessors, std::vector<Mesh> meshes, Scene& scene);

}  // namespace gnomon
