// The nodes of a glTF file: placed meshes, instances, lights and cameras.
#include "scene/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/log.h"
#include "scene/gltf/gltf_animation.h"
#include "scene/gltf/gltf_hierarchy.h"
#include "scene/gltf/gltf_lights_cameras.h"
#include "scene/gltf/gltf_pose.h"

namespace gnomon {
namespace {

// Against instance counts that multiply up: some hundred megabytes of objects.
constexpr size_t k_max_objects = 1u << 20;

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

const char* kind_name(LightKind kind) {
  return kind == LightKind::directional ? "sun" : kind == LightKind::point ? "point" : "spot";
}

class Nodes {
 public:
  Nodes(GltfDocument& document, const GltfAccessors& accessors, std::vector<GltfMesh> meshes, const SceneFileOptions& options,
        GltfHierarchy hierarchy, Scene& scene)
      : document_(document),
        accessors_(accessors),
        meshes_(std::move(meshes)),
        scene_(scene),
        hierarchy_(std::move(hierarchy)) {
    const GltfValue root = document.root();
    skin_count_ = root.count("skins");
    for (const GltfValue& camera : root.objects("cameras")) cameras_.push_back(read_gltf_camera(camera));
    if (const auto lights = root.extension("KHR_lights_punctual")) {
      for (const GltfValue& light : lights->objects("lights")) lights_.push_back(read_gltf_light(light));
    }
    weights_ = apply_animation(document, accessors, options.animation, options.params.time, hierarchy_);
    world_from_nodes_ = hierarchy_.world_from_nodes();
  }

  void add(const std::vector<int>& shown) {
    for (const int node : shown) add_node(node);
    scene_.meshes = posed_meshes(document_, std::move(meshes_), poses_);
    settle_far_planes();
  }

 private:
  void add_node(int node) {
    const GltfValue& json = hierarchy_.json(node);
    const mat4& world_from_node = world_from_nodes_[static_cast<size_t>(node)];
    const int mesh = json.index("mesh", meshes_.size(), "meshes");
    const int camera = json.index("camera", cameras_.size(), "cameras");
    if (mesh >= 0) add_mesh(node, mesh);
    if (camera >= 0) {
      Camera placed = cameras_[static_cast<size_t>(camera)];
      placed.name = json.text("name", placed.name);
      if (placed.name.empty()) placed.name = fmt::format("camera {}", scene_.cameras.size());
      placed.world_from_view = rigid(world_from_node);
      scene_.cameras.push_back(std::move(placed));
    }
    if (const auto extension = json.extension("KHR_lights_punctual")) {
      Light light = lights_.empty()
                        ? Light{}
                        : Light(lights_[static_cast<size_t>(extension->required_index("light", lights_.size(), "lights"))]);
      if (lights_.empty()) extension->fail_in("light", "the file has no lights");
      light.name = json.text("name", light.name);
      // As the command line counts them.
      if (light.name.empty()) light.name = fmt::format("{} {}", kind_name(light.kind), scene_.lights.size());
      const mat4 placed = rigid(world_from_node);
      light.position = vec3(placed[3]);
      light.direction = -vec3(placed[2]);
      scene_.lights.push_back(std::move(light));
    }
  }

  // --- objects ---

  void add_mesh(int node, int mesh) {
    const GltfValue& json = hierarchy_.json(node);
    const GltfPose pose = pose_of(node, mesh);
    // A skin places its vertices by itself: where the node stands does not matter.
    const mat4 world_from_node = pose.skin >= 0 ? mat4(1.0f) : world_from_nodes_[static_cast<size_t>(node)];
    const auto instancing = json.extension("EXT_mesh_gpu_instancing");
    const std::vector<mat4> instances = instancing ? read_instances(*instancing) : std::vector<mat4>{mat4(1.0f)};
    if (meshes_[static_cast<size_t>(mesh)].parts.empty()) return;
    if (instances.size() > k_max_objects - scene_.objects.size())
      json.fail_here("more than {} objects in the scene", k_max_objects);
    const std::string name = json.text("name", json.place());
    // glTF has no word for it; "extras" is where applications put theirs.
    const auto extras = json.object("extras");
    const bool casts = !extras || extras->flag("casts_shadow", true);
    const int placed_mesh = place_mesh(pose);
    for (size_t i = 0; i < instances.size(); ++i) {
      Object object;
      object.name = instancing ? fmt::format("{}[{}]", name, i) : name;
      object.world_from_object = world_from_node * instances[i];
      object.mesh = placed_mesh;
      object.casts = casts;
      scene_.objects.push_back(std::move(object));
    }
  }

  GltfPose pose_of(int node, int mesh) {
    const GltfValue& json = hierarchy_.json(node);
    const GltfMesh& source = meshes_[static_cast<size_t>(mesh)];
    GltfPose pose{.mesh = mesh, .weights = {}, .skin = json.index("skin", skin_count_, "skins"), .world_from_bind = {}};
    const auto animated = weights_.find(node);
    if (animated != weights_.end()) {
      pose.weights = animated->second;
    } else {
      pose.weights = json.has("weights") ? json.floats("weights") : source.weights;
    }
    // Shapes that are the same share a mesh.
    size_t targets = 0;
    for (const GltfPart& part : source.parts) targets = std::max(targets, part.targets.size());
    pose.weights.resize(std::min(pose.weights.size(), targets));
    while (!pose.weights.empty() && pose.weights.back() == 0.0f) pose.weights.pop_back();
    const auto rigid =
        std::find_if(source.parts.begin(), source.parts.end(), [](const GltfPart& part) { return part.influences.empty(); });
    if (pose.skin >= 0 && rigid != source.parts.end()) {
      log_warning("{}: {}: has a skin, but {} names no joints (JOINTS_0); the whole mesh is placed like any other",
                  document_.name(), json.place(), rigid->place);
      pose.skin = -1;
    }
    return pose;
  }

  int place_mesh(GltfPose pose) {
    const auto [entry, is_new] =
        mesh_index_.try_emplace(std::tuple(pose.mesh, pose.skin, pose.weights), static_cast<int>(poses_.size()));
    if (!is_new) return entry->second;
    if (pose.skin >= 0) pose.world_from_bind = joints_of(pose.skin);
    poses_.push_back(std::move(pose));
    return entry->second;
  }

  // Once for all that a skin carries: hundreds of nodes may share one of hundreds of joints.
  std::span<const mat4> joints_of(int skin) {
    const auto [entry, is_new] = world_from_bind_.try_emplace(skin);
    if (is_new) entry->second = world_from_bind(read_gltf_skin(document_, accessors_, skin), world_from_nodes_);
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

  GltfDocument& document_;
  const GltfAccessors& accessors_;
  std::vector<GltfMesh> meshes_;
  Scene& scene_;
  GltfHierarchy hierarchy_;
  std::vector<mat4> world_from_nodes_;
  MorphWeights weights_;
  size_t skin_count_ = 0;
  std::vector<Camera> cameras_;
  std::vector<Light> lights_;
  std::map<int, std::vector<mat4>> world_from_bind_;                    // of each skin's joints
  std::vector<GltfPose> poses_;                                         // of the scene's meshes, one each
  std::map<std::tuple<int, int, std::vector<float>>, int> mesh_index_;  // mesh, skin, weights -> of the scene
};

}  // namespace

void add_gltf_nodes(GltfDocument& document, const GltfAccessors& accessors, std::vector<GltfMesh> meshes,
                    const SceneFileOptions& options, GltfHierarchy hierarchy, const std::vector<int>& shown, Scene& scene) {
  Nodes(document, accessors, std::move(meshes), options, std::move(hierarchy), scene).add(shown);
}

}  // namespace gnomon
