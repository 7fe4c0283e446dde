// The node hierarchy of a glTF file: placed meshes, instances, lights and cameras.
#include "scene/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/log.h"
#include "scene/gltf/gltf_lights_cameras.h"

namespace gnomon {
namespace {

// Against instance counts that multiply up: some hundred megabytes of objects.
constexpr size_t k_max_objects = 1u << 20;

glm::quat rotation_of(const vec4& xyzw) { return glm::normalize(glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z)); }

mat4 compose(const vec3& translation, const glm::quat& rotation, const vec3& scale) {
  return glm::translate(mat4(1.0f), translation) * glm::mat4_cast(rotation) * glm::scale(mat4(1.0f), scale);
}

// The place and the axes of a node without its scale; lights and cameras have none.
mat4 rigid(const mat4& world_from_node) {
  const vec3 z(world_from_node[2]), y(world_from_node[1]);
  const float z_length = glm::length(z);
  mat4 result(1.0f);
  result[3] = world_from_node[3];
  if (!(z_length > 0.0f) || !std::isfinite(z_length)) return result;
  const vec3 back = z / z_length;
  vec3 right = glm::cross(y, back), unused;
  const float right_length = glm::length(right);
  if (right_length > 0.0f && std::isfinite(right_length)) {
    right /= right_length;
  } else {
    orthonormal_basis(back, right, unused);
  }
  result[0] = vec4(right, 0), result[1] = vec4(glm::cross(back, right), 0), result[2] = vec4(back, 0);
  return result;
}

class Nodes {
 public:
  Nodes(const GltfDocument& document, const GltfAccessors& accessors, std::vector<Mesh> meshes, Scene& scene)
      : document_(document), accessors_(accessors), meshes_(std::move(meshes)), scene_(scene) {
    const GltfValue root = document.root();
    nodes_ = root.objects("nodes");
    for (const GltfValue& camera : root.objects("cameras")) cameras_.push_back(read_gltf_camera(camera));
    if (const auto lights = root.extension("KHR_lights_punctual")) {
      for (const GltfValue& light : lights->objects("lights")) lights_.push_back(read_gltf_light(light));
    }
    read_hierarchy();
  }

  void add() {
    for (const int root : scene_roots()) visit(root);
    for (const auto& [mesh, index] : mesh_index_)
      scene_.meshes[static_cast<size_t>(index)] = std::move(meshes_[static_cast<size_t>(mesh)]);
    if (document_.root().has("skins"))
      log_warning("{}: skins are not supported; skinned meshes keep their bind pose", document_.name());
    settle_far_planes();
  }

 private:
  // --- hierarchy ---

  struct Node {
    mat4 parent_from_node = mat4(1.0f);
    std::vector<int> children;
    int parent = -1;
  };

  mat4 local_transform(const GltfValue& json) const {
    if (const auto matrix = json.matrix("matrix")) {
      mat4 m = *matrix;
      const vec4 last(m[0].w, m[1].w, m[2].w, m[3].w);
      if (glm::any(glm::greaterThan(glm::abs(last - vec4(0, 0, 0, 1)), vec4(1e-4f)))) {
        json.fail_in("matrix", "its last row is {} {} {} {}; valid: 0 0 0 1", last.x, last.y, last.z, last.w);
      }
      for (int i = 0; i < 4; ++i) m[i].w = i == 3 ? 1.0f : 0.0f;
      return m;
    }
    const vec4 rotation = json.vector<4>("rotation", vec4(0, 0, 0, 1));
    if (!(glm::length(rotation) > 1e-6f) || !std::isfinite(glm::length(rotation)))
      json.fail_in("rotation", "valid: a unit quaternion");
    return compose(json.vector<3>("translation", vec3(0.0f)), rotation_of(rotation), json.vector<3>("scale", vec3(1.0f)));
  }

  void read_hierarchy() {
    hierarchy_.resize(nodes_.size());
    for (size_t i = 0; i < nodes_.size(); ++i) {
      Node& node = hierarchy_[i];
      node.parent_from_node = local_transform(nodes_[i]);
      node.children = nodes_[i].indices("children", nodes_.size(), "nodes");
      for (size_t k = 0; k < node.children.size(); ++k) {
        int& parent = hierarchy_[static_cast<size_t>(node.children[k])].parent;
        if (parent >= 0) {
          nodes_[i].fail_in(fmt::format("children[{}]", k),
                            "node {} already has the parent {}; valid: each node below one parent", node.children[k], parent);
        }
        parent = static_cast<int>(i);
      }
    }
    refuse_cycles();
  }

  // With one parent each, what cannot be reached from a node without parent goes round in a circle.
  void refuse_cycles() const {
    std::vector<int> open;
    std::vector<bool> reached(hierarchy_.size(), false);
    for (size_t i = 0; i < hierarchy_.size(); ++i) {
      if (hierarchy_[i].parent < 0) open.push_back(static_cast<int>(i));
    }
    while (!open.empty()) {
      const auto node = static_cast<size_t>(open.back());
      open.pop_back();
      reached[node] = true;
      open.insert(open.end(), hierarchy_[node].children.begin(), hierarchy_[node].children.end());
    }
    const auto circular = std::find(reached.begin(), reached.end(), false);
    if (circular != reached.end())
      nodes_[static_cast<size_t>(circular - reached.begin())].fail_in("children",
                                                                      "the node is its own ancestor; valid: a tree");
  }

  // Of the default scene, else the first; of a file without scenes all nodes.
  std::vector<int> scene_roots() const {
    const auto scenes = document_.root().objects("scenes");
    std::vector<std::vector<int>> roots;
    for (const GltfValue& json : scenes) {
      roots.push_back(json.indices("nodes", nodes_.size(), "nodes"));
      for (size_t i = 0; i < roots.back().size(); ++i) {
        const int node = roots.back()[i], parent = hierarchy_[static_cast<size_t>(node)].parent;
        if (parent >= 0)
          json.fail_in(fmt::format("nodes[{}]", i), "node {} is a child of node {}; valid: nodes without parent", node, parent);
      }
      std::sort(roots.back().begin(), roots.back().end());
      roots.back().erase(std::unique(roots.back().begin(), roots.back().end()), roots.back().end());
    }
    const int chosen = document_.root().index("scene", scenes.size(), "scenes");
    if (!roots.empty()) return roots[static_cast<size_t>(std::max(chosen, 0))];
    std::vector<int> all;
    for (size_t i = 0; i < hierarchy_.size(); ++i) {
      if (hierarchy_[i].parent < 0) all.push_back(static_cast<int>(i));
    }
    return all;
  }

  // With a stack of its own: a chain of a million nodes must not end ours.
  void visit(int root) {
    std::vector<std::pair<int, mat4>> open = {{root, mat4(1.0f)}};
    while (!open.empty()) {
      const auto [index, world_from_parent] = open.back();
      open.pop_back();
      const Node& node = hierarchy_[static_cast<size_t>(index)];
      const mat4 world_from_node = world_from_parent * node.parent_from_node;
      add_node(nodes_[static_cast<size_t>(index)], world_from_node);
      const auto first_child = static_cast<ptrdiff_t>(open.size());
      for (const int child : node.children) open.emplace_back(child, world_from_node);
      std::reverse(open.begin() + first_child, open.end());  // the first comes off the stack first
    }
  }

  void add_node(const GltfValue& json, const mat4& world_from_node) {
    const int mesh = json.index("mesh", meshes_.size(), "meshes");
    const int camera = json.index("camera", cameras_.size(), "cameras");
    if (mesh >= 0) add_mesh(json, mesh, world_from_node);
    if (camera >= 0) {
      Camera placed = cameras_[static_cast<size_t>(camera)];
      placed.name = json.text("name", placed.name);
      placed.world_from_view = rigid(world_from_node);
      scene_.cameras.push_back(std::move(placed));
    }
    if (const auto extension = json.extension("KHR_lights_punctual")) {
      Light light = lights_.empty()
                        ? Light{}
                        : Light(lights_[static_cast<size_t>(extension->required_index("light", lights_.size(), "lights"))]);
      if (lights_.empty()) extension->fail_in("light", "the file has no lights");
      light.name = json.text("name", light.name);
      const mat4 placed = rigid(world_from_node);
      light.position = vec3(placed[3]);
      light.direction = -vec3(placed[2]);
      scene_.lights.push_back(std::move(light));
    }
  }

  // --- objects ---

  void add_mesh(const GltfValue& json, int mesh, const mat4& world_from_node) {
    const auto instancing = json.extension("EXT_mesh_gpu_instancing");
    const std::vector<mat4> instances = instancing ? read_instances(*instancing) : std::vector<mat4>{mat4(1.0f)};
    if (meshes_[static_cast<size_t>(mesh)].parts.empty()) return;
    if (instances.size() > k_max_objects - scene_.objects.size())
      json.fail_here("more than {} objects in the scene", k_max_objects);
    const std::string name = json.text("name", json.place());
    // glTF has no word for it; "extras" is where applications put theirs.
    const auto extras = json.object("extras");
    const bool casts = !extras || extras->flag("casts_shadow", true);
    for (size_t i = 0; i < instances.size(); ++i) {
      Object object;
      object.name = instancing ? fmt::format("{}[{}]", name, i) : name;
      object.world_from_object = world_from_node * instances[i];
      object.mesh = place_mesh(mesh);
      object.casts = casts;
      scene_.objects.push_back(std::move(object));
    }
  }

  int place_mesh(int mesh) {
    const auto [entry, is_new] = mesh_index_.try_emplace(mesh, static_cast<int>(scene_.meshes.size()));
    if (is_new) scene_.meshes.emplace_back();
    return entry->second;
  }

  std::vector<mat4> read_instances(const GltfValue& extension) const {
    const GltfValue json = extension.required_object("attributes");
    const int translation = json.index("TRANSLATION", accessors_.count(), "accessors");
    const int rotation = json.index("ROTATION", accessors_.count(), "accessors");
    const int scale = json.index("SCALE", accessors_.count(), "accessors");
    const int first = std::max({translation, rotation, scale});
    if (first < 0) json.fail_here("valid: at least one of TRANSLATION, ROTATION, SCALE");
    const size_t count = accessors_.element_count(first);
    for (const int accessor : {translation, rotation, scale}) {
      if (accessor >= 0 && accessors_.element_count(accessor) != count)
        json.fail_here("its accessors differ in count; valid: one per instance");
    }
    if (count > k_max_objects) json.fail_here("{} instances; valid: at most {}", count, k_max_objects);
    std::vector<vec3> translations(count, vec3(0.0f)), scales(count, vec3(1.0f));
    std::vector<vec4> rotations(count, vec4(0, 0, 0, 1));
    if (translation >= 0) translations = accessors_.floats<3>(translation, json.where("TRANSLATION"));
    if (rotation >= 0) rotations = accessors_.floats<4>(rotation, json.where("ROTATION"));
    if (scale >= 0) scales = accessors_.floats<3>(scale, json.where("SCALE"));
    std::vector<mat4> result;
    result.reserve(count);
    for (size_t i = 0; i < count; ++i) {
      if (!(glm::length(rotations[i]) > 1e-6f)) json.fail_in("ROTATION", "instance {}: valid: a unit quaternion", i);
      result.push_back(compose(translations[i], rotation_of(rotations[i]), scales[i]));
    }
    return result;
  }

  // A perspective without zfar reaches to infinity; techniques that slice the view need an end: that of the scene.
  void settle_far_planes() {
    const Box box = scene_.bounds();
    for (Camera& camera : scene_.cameras) {
      if (camera.far > 0.0f) continue;
      float farthest = 0.0f;
      for (int i = 0; i < 8 && !box.empty(); ++i)
        farthest = std::max(farthest, glm::distance(box.corner(i), vec3(camera.world_from_view[3])));
      camera.far = std::max({1.01f * farthest, 100.0f * camera.near});
    }
  }

  const GltfDocument& document_;
  const GltfAccessors& accessors_;
  std::vector<Mesh> meshes_;
  Scene& scene_;
  std::vector<GltfValue> nodes_;
  std::vector<Node> hierarchy_;
  std::vector<Camera> cameras_;
  std::vector<Light> lights_;
  std::map<int, int> mesh_index_;  // of the file -> of the scene: only placed meshes are kept
};

}  // namespace

void add_gltf_nodes(const GltfDocument& document, const GltfAccessors& accessors, std::vector<Mesh> meshes, Scene& scene) {
  Nodes(document, accessors, std::move(meshes), scene).add();
}

}  // namespace gnomon
