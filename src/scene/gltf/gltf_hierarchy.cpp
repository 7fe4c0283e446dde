// The node tree of a glTF file: transforms, parents, scenes.
#include "scene/gltf/gltf_hierarchy.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/log.h"

namespace gnomon {
namespace {

GltfTransform read_transform(const GltfValue& json) {
  GltfTransform result;
  if (const auto matrix = json.matrix("matrix")) {
    mat4 m = *matrix;
    const vec4 last(m[0].w, m[1].w, m[2].w, m[3].w);
    if (glm::any(glm::greaterThan(glm::abs(last - vec4(0, 0, 0, 1)), vec4(1e-4f)))) {
      json.fail_in("matrix", "its last row is {} {} {} {}; valid: 0 0 0 1", last.x, last.y, last.z, last.w);
    }
    for (int i = 0; i < 4; ++i) m[i].w = i == 3 ? 1.0f : 0.0f;
    result.matrix = m;
    return result;
  }
  result.rotation = json.vector<4>("rotation", result.rotation);
  if (!(glm::length(result.rotation) > 1e-6f) || !std::isfinite(glm::length(result.rotation)))
    json.fail_in("rotation", "has no length that a number can hold; valid: a unit quaternion");
  result.translation = json.vector<3>("translation", result.translation);
  result.scale = json.vector<3>("scale", result.scale);
  return result;
}

}  // namespace

glm::quat rotation_of(const vec4& xyzw) { return glm::normalize(glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z)); }

mat4 compose(const vec3& translation, const glm::quat& rotation, const vec3& scale) {
  return glm::translate(mat4(1.0f), translation) * glm::mat4_cast(rotation) * glm::scale(mat4(1.0f), scale);
}

std::string named(const GltfValue& thing, int number) {
  const std::string name = thing.text("name", "");
  return name.empty() ? fmt::format("{}", number) : fmt::format("{} ('{}')", number, name);
}

std::string names_of(const std::vector<GltfValue>& list) {
  std::vector<std::string> names;
  for (size_t i = 0; i < list.size(); ++i) names.push_back(named(list[i], static_cast<int>(i)));
  return fmt::format("{}", fmt::join(names, ", "));
}

int find_named(const std::vector<GltfValue>& list, const std::string& name_or_number) {
  for (size_t i = 0; i < list.size(); ++i) {
    if (list[i].text("name", "") == name_or_number) return static_cast<int>(i);
  }
  size_t number = 0;
  const char* end = name_or_number.data() + name_or_number.size();
  const auto [read, error] = std::from_chars(name_or_number.data(), end, number);
  return error == std::errc() && read == end && number < list.size() ? static_cast<int>(number) : -1;
}

GltfHierarchy::GltfHierarchy(const GltfDocument& document)
    : document_(document), json_(document.root().objects("nodes")), nodes_(json_.size()) {
  for (size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    node.transform = read_transform(json_[i]);
    node.children = json_[i].indices("children", nodes_.size(), "nodes");
    for (size_t k = 0; k < node.children.size(); ++k) {
      int& parent = nodes_[static_cast<size_t>(node.children[k])].parent;
      if (parent >= 0) {
        json_[i].fail_in(fmt::format("children[{}]", k), "node {} already has the parent {}; valid: each node below one parent",
                         node.children[k], parent);
      }
      parent = static_cast<int>(i);
    }
  }
  refuse_cycles();
}

// With one parent each, what cannot be reached from a node without parent goes round in a circle.
void GltfHierarchy::refuse_cycles() const {
  std::vector<bool> reached(nodes_.size(), false);
  for (const int node : from_the_top()) reached[static_cast<size_t>(node)] = true;
  const auto circular = std::find(reached.begin(), reached.end(), false);
  if (circular != reached.end())
    json_[static_cast<size_t>(circular - reached.begin())].fail_in("children", "the node is its own ancestor; valid: a tree");
}

// Without recursion: a chain of a million nodes must not end our stack.
std::vector<int> GltfHierarchy::from_the_top() const {
  std::vector<int> order;
  order.reserve(nodes_.size());
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent < 0) order.push_back(static_cast<int>(i));
  }
  for (size_t i = 0; i < order.size(); ++i) {
    const std::vector<int>& below = children(order[i]);
    order.insert(order.end(), below.begin(), below.end());
  }
  return order;
}

std::vector<mat4> GltfHierarchy::world_from_nodes() const {
  std::vector<mat4> world(nodes_.size());
  for (const int index : from_the_top()) {
    const Node& node = nodes_[static_cast<size_t>(index)];
    const mat4 parent = node.parent < 0 ? mat4(1.0f) : world[static_cast<size_t>(node.parent)];
    world[static_cast<size_t>(index)] = parent * node.transform.parent_from_node();
  }
  return world;
}

std::vector<int> GltfHierarchy::checked_roots(const GltfValue& scene) const {
  std::vector<int> roots = scene.indices("nodes", nodes_.size(), "nodes");
  for (size_t i = 0; i < roots.size(); ++i) {
    const int node = roots[i], parent = nodes_[static_cast<size_t>(node)].parent;
    if (parent >= 0)
      scene.fail_in(fmt::format("nodes[{}]", i), "node {} is a child of node {}; valid: nodes without parent", node, parent);
  }
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

std::vector<int> GltfHierarchy::roots(const std::string& scene) const {
  const auto scenes = document_.root().objects("scenes");
  std::vector<std::vector<int>> roots;
  for (const GltfValue& json : scenes) roots.push_back(checked_roots(json));
  int chosen = std::max(document_.root().index("scene", scenes.size(), "scenes"), 0);
  if (!scene.empty()) {
    chosen = find_named(scenes, scene);
    if (chosen < 0)
      fail_usage("{}: --gltf-scene {}: valid: {}", document_.name(), scene,
                 scenes.empty() ? "nothing, the file has no scenes" : names_of(scenes));
  } else if (scenes.size() > 1) {
    log_info("{}: shows its scene {}, one of {}; --gltf-scene shows another", document_.name(),
             named(scenes[static_cast<size_t>(chosen)], chosen), scenes.size());
  }
  if (!roots.empty()) return roots[static_cast<size_t>(chosen)];
  std::vector<int> all;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent < 0) all.push_back(static_cast<int>(i));
  }
  return all;
}

std::vector<int> GltfHierarchy::shown_nodes(const std::string& scene) const {
  const std::vector<int> roots_of_scene = roots(scene);
  std::vector<int> shown;
  // With a stack of its own: a chain of a million nodes must not end ours.
  std::vector<int> open(roots_of_scene.rbegin(), roots_of_scene.rend());
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    const auto visibility = json(node).extension("KHR_node_visibility");
    if (visibility && !visibility->flag("visible", true)) continue;  // with all below it
    shown.push_back(node);
    const std::vector<int>& below = children(node);
    open.insert(open.end(), below.rbegin(), below.rend());  // the first comes off the stack first
  }
  return shown;
}

std::vector<bool> GltfHierarchy::meshes_of(const std::vector<int>& nodes) const {
  std::vector<bool> has(document_.root().count("meshes"), nodes_.empty());
  for (const int node : nodes) {
    const int mesh = json(node).index("mesh", has.size(), "meshes");
    if (mesh >= 0) has[static_cast<size_t>(mesh)] = true;
  }
  return has;
}

}  // namespace gnomon
