// Skins: joints that carry the vertices of a part.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/gltf/gltf_accessors.h"
#include "scene/scene.h"

namespace gnomon {

// Which joints carry a vertex: `per_vertex` entries each, whose weights sum up to 1.
struct SkinInfluences {
  size_t per_vertex = 0;
  std::vector<uint32_t> joints;
  std::vector<float> weights;

  bool empty() const { return per_vertex == 0; }
};

// Makes weights sum up to 1; a vertex without any follows its first joint. Returns how many are without.
size_t normalise(SkinInfluences& influences);

struct GltfSkin {
  std::vector<int> joints;            // nodes
  std::vector<mat4> joint_from_bind;  // inverse bind matrices, as many
};
GltfSkin read_gltf_skin(const GltfDocument& document, const GltfAccessors& accessors, int skin);

// Of each joint, as it stands now.
std::vector<mat4> world_from_bind(const GltfSkin& skin, std::span<const mat4> world_from_nodes);

// Carries the vertices into world space: linear blending. Normals go by the inverse transpose; where joints mirror, triangles
// keep their front. The first vertex whose joint is not there, or nullopt; the part is then unchanged.
std::optional<size_t> apply_skin(MeshPart& part, const SkinInfluences& influences, std::span<const mat4> world_from_bind);

}  // namespace gnomon
