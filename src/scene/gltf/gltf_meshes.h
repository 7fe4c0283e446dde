// Meshes of a glTF file as triangles.
#pragma once

#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_materials.h"
#include "scene/scene.h"

namespace gnomon {

// Every mesh of the file, in its order, placed or not; one without triangles has no parts.
std::vector<Mesh> read_gltf_meshes(GltfDocument& document, const GltfAccessors& accessors, GltfMaterials& materials);

}  // namespace gnomon
