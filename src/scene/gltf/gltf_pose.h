// The shapes that nodes give to meshes: morph targets and skins, evaluated where the file is read.
#pragma once

#include <span>
#include <vector>

#include "scene/gltf/gltf_meshes.h"

namespace gnomon {

// One shape of a mesh of the file.
struct GltfPose {
  int mesh = 0;
  std::vector<float> weights;  // of its morph targets
  int skin = -1;
  std::span<const mat4> world_from_bind;  // of the skin's joints, where there is one; vertices are then in world space
};

// A finished mesh (scene/finish_part.h) for each pose. Refuses joints that the skin does not have and shapes beyond what floats
// can hold.
std::vector<Mesh> posed_meshes(GltfDocument& document, std::vector<GltfMesh> meshes, const std::vector<GltfPose>& poses);

}  // namespace gnomon
