// Meshes of a glTF file as triangles.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/gltf/gltf_materials.h"
#include "scene/gltf/gltf_morph.h"
#include "scene/gltf/gltf_skin.h"
#include "scene/scene.h"

namespace gnomon {

// As the file has it: neither morphed, nor skinned, nor finished.
struct GltfPart {
  MeshPart part;
  std::vector<MorphTarget> targets;
  SkinInfluences influences;
  std::vector<uint32_t> file_vertices;  // which of the file's vertices these are, for messages
  std::string place;                    // of its primitive
};

struct GltfMesh {
  std::string name;
  std::vector<float> weights;  // of its morph targets, where a node does not say otherwise
  std::vector<GltfPart> parts;
};

// The meshes of the file, in its order; one without triangles has no parts, nor has one that is not `shown`, whose data may be
// damaged.
std::vector<GltfMesh> read_gltf_meshes(GltfDocument& document, const GltfAccessors& accessors, const std::vector<bool>& shown,
                                       GltfMaterials& materials);

}  // namespace gnomon
