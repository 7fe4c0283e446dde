// Skins: joints that carry the vertices of a part.
#include "scene/gltf/gltf_skin.h"

#include <algorithm>

namespace gnomon {
namespace {

std::optional<size_t> first_without_joint(const SkinInfluences& influences, size_t joints) {
  for (size_t i = 0; i < influences.joints.size(); ++i) {
    // Exporters leave anything in places without weight.
    if (influences.weights[i] != 0.0f && influences.joints[i] >= joints) return i / influences.per_vertex;
  }
  return std::nullopt;
}

mat4 blended(const SkinInfluences& influences, size_t vertex, std::span<const mat4> joints) {
  mat4 sum(0.0f);
  for (size_t k = vertex * influences.per_vertex; k < (vertex + 1) * influences.per_vertex; ++k) {
    if (influences.weights[k] != 0.0f) sum += influences.weights[k] * joints[influences.joints[k]];
  }
  return sum;
}

// The inverse transpose but for a factor: that of a flattening transform exists too.
mat3 normal_transform(const mat3& m) {
  const mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0f ? -1.0f * cofactors : cofactors;
}

bool mostly_mirrors(std::span<const mat4> joints) {
  const auto mirrors = std::count_if(joints.begin(), joints.end(), [](const mat4& m) { return glm::determinant(mat3(m)) < 0; });
  return 2 * static_cast<size_t>(mirrors) > joints.size();
}

}  // namespace

size_t normalise(SkinInfluences& influences) {
  size_t without = 0;
  const size_t n = influences.per_vertex;
  for (size_t first = 0; first < influences.weights.size(); first += n) {
    float sum = 0.0f;
    for (size_t k = 0; k < n; ++k) sum += influences.weights[first + k];
    if (sum > 0.0f) {
      for (size_t k = 0; k < n; ++k) influences.weights[first + k] /= sum;
    } else {
      ++without;
      std::fill_n(influences.weights.begin() + static_cast<ptrdiff_t>(first), n, 0.0f);
      influences.weights[first] = 1.0f;
    }
  }
  return without;
}

GltfSkin read_gltf_skin(const GltfDocument& document, const GltfAccessors& accessors, int skin) {
  const GltfValue root = document.root(), json = root.element("skins", static_cast<size_t>(skin));
  GltfSkin result;
  result.joints = json.indices("joints", root.count("nodes"), "nodes");
  if (result.joints.empty()) json.fail_in("joints", "is empty; valid: at least one node");
  result.joint_from_bind.assign(result.joints.size(), mat4(1.0f));
  const int accessor = json.index("inverseBindMatrices", accessors.count(), "accessors");
  if (accessor < 0) return result;
  const std::vector<float> numbers = accessors.numbers(accessor, 16, json.where("inverseBindMatrices"));
  if (numbers.size() < 16 * result.joints.size()) {
    json.fail_in("inverseBindMatrices", "has {} matrices; valid: one for each of {} joints", numbers.size() / 16,
                 result.joints.size());
  }
  for (size_t i = 0; i < result.joints.size(); ++i) {
    result.joint_from_bind[i] = glm::make_mat4(&numbers[16 * i]);
    for (int c = 0; c < 4; ++c) result.joint_from_bind[i][c].w = c == 3 ? 1.0f : 0.0f;  // affine, whatever rounding left
  }
  return result;
}

std::vector<mat4> world_from_bind(const GltfSkin& skin, std::span<const mat4> world_from_nodes) {
  std::vector<mat4> result;
  for (size_t i = 0; i < skin.joints.size(); ++i)
    result.push_back(world_from_nodes[static_cast<size_t>(skin.joints[i])] * skin.joint_from_bind[i]);
  return result;
}

std::optional<size_t> apply_skin(MeshPart& part, const SkinInfluences& influences, std::span<const mat4> joints) {
  if (const auto bad = first_without_joint(influences, joints.size())) return bad;
  for (size_t i = 0; i < part.positions.size(); ++i) {
    const mat4 world = blended(influences, i, joints);
    part.positions[i] = vec3(world * vec4(part.positions[i], 1.0f));
    if (!part.normals.empty()) part.normals[i] = normal_transform(mat3(world)) * part.normals[i];
    if (!part.tangents.empty()) part.tangents[i] = vec4(mat3(world) * vec3(part.tangents[i]), part.tangents[i].w);
  }
  if (!mostly_mirrors(joints)) return std::nullopt;
  for (size_t i = 0; i < part.indices.size(); i += 3) std::swap(part.indices[i + 1], part.indices[i + 2]);
  for (vec4& tangent : part.tangents) tangent.w = -tangent.w;
  return std::nullopt;
}

}  // namespace gnomon
