// The node tree of a glTF file: transforms, parents, scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/gltf_document.h"

namespace gnomon {

glm::quat rotation_of(const vec4& xyzw);
mat4 compose(const vec3& translation, const glm::quat& rotation, const vec3& scale);

// Of a node in its parent.
struct GltfTransform {
  vec3 translation = vec3(0.0f), scale = vec3(1.0f);
  vec4 rotation = vec4(0, 0, 0, 1);
  std::optional<mat4> matrix;  // instead of the three

  mat4 parent_from_node() const { return matrix ? *matrix : compose(translation, rotation_of(rotation), scale); }
};

// Named things as messages show them: "0 ('walk')"; all of a list, with commas.
std::string named(const GltfValue& thing, int number);
std::string names_of(const std::vector<GltfValue>& list);
// The thing of that name, else of that number; -1 where there is none.
int find_named(const std::vector<GltfValue>& list, const std::string& name_or_number);

class GltfHierarchy {
 public:
  // Refuses cycles and nodes with two parents.
  explicit GltfHierarchy(const GltfDocument& document);

  size_t size() const { return nodes_.size(); }
  const GltfValue& json(int node) const { return json_[static_cast<size_t>(node)]; }
  GltfTransform& transform(int node) { return nodes_[static_cast<size_t>(node)].transform; }
  const std::vector<int>& children(int node) const { return nodes_[static_cast<size_t>(node)].children; }

  // Of the scene of that name or number; empty: the default scene, else the first; of a file without scenes all nodes that
  // have no parent. Usage error for a name that is not there.
  std::vector<int> roots(const std::string& scene) const;
  std::vector<mat4> world_from_nodes() const;
  // Those of the chosen scene that are visible (KHR_node_visibility), parents before their children.
  std::vector<int> shown_nodes(const std::string& scene) const;
  // By mesh of the file: whether one of the nodes has it. In a file without any node all do: what is wrong with them is then
  // the better answer than that there is nothing to draw.
  std::vector<bool> meshes_of(const std::vector<int>& nodes) const;

 private:
  struct Node {
    GltfTransform transform;
    std::vector<int> children;
    int parent = -1;
  };

  void refuse_cycles() const;
  // Every node, parents before their children, or fewer where nodes go round in a circle.
  std::vector<int> from_the_top() const;
  std::vector<int> checked_roots(const GltfValue& scene) const;

  const GltfDocument& document_;
  std::vector<GltfValue> json_;
  std::vector<Node> nodes_;
};

}  // namespace gnomon
