// Meshes of a glTF file as triangles: attributes, morph targets, Draco data, strips and fans.
#include "scene/gltf/gltf_meshes.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/interrupt.h"
#include "base/log.h"
#include "scene/gltf/gltf_compression.h"

namespace gnomon {
namespace {

enum Mode { k_points, k_lines, k_line_loop, k_line_strip, k_triangles, k_strip, k_fan };

std::vector<uint32_t> triangles_of(Mode mode, std::vector<uint32_t> indices) {
  if (mode == k_triangles || indices.size() < 3) {
    indices.resize(indices.size() / 3 * 3);
    return indices;
  }
  std::vector<uint32_t> triangles;
  triangles.reserve(3 * (indices.size() - 2));
  for (size_t i = 0; i + 2 < indices.size(); ++i) {
    if (mode == k_fan) {
      triangles.insert(triangles.end(), {indices[i + 1], indices[i + 2], indices[0]});
    } else {
      const size_t odd = i % 2;  // every other triangle of a strip winds the other way
      triangles.insert(triangles.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
    }
  }
  return triangles;
}

// What was wrong with the vertices of a mesh and could be mended.
struct Mended {
  size_t normals = 0, tangents = 0, uvs = 0, colours = 0, without_weights = 0;
  bool other_morphs = false;  // targets of attributes that are not read
};

// A direction without length is as good as none.
template <class T>
size_t without_length(const std::vector<T>& directions) {
  return static_cast<size_t>(
      std::count_if(directions.begin(), directions.end(), [](const T& v) { return !(glm::length(glm::dvec3(v)) > 1e-20); }));
}

// One primitive: finds out which vertices its triangles use, then reads only those. Files often share one large vertex
// buffer among hundreds of primitives.
class Primitive {
 public:
  Primitive(GltfDocument& document, const GltfAccessors& accessors, GltfMaterials& materials, const GltfValue& json,
            const std::string& mesh, Mended& mended)
      : document_(document), accessors_(accessors), materials_(materials), json_(json), mesh_(mesh), mended_(mended) {}

  // nullopt where there is nothing to draw as triangles.
  std::optional<GltfPart> read() {
    const auto mode = static_cast<Mode>(json_.integer("mode", k_triangles, k_points, k_fan));
    const int material = json_.index("material", document_.root().count("materials"), "materials");
    const GltfValue attributes = json_.required_object("attributes");
    for (const auto& [name, accessor] : attributes.named_indices(accessors_.count(), "accessors"))
      accessor_of_[name] = accessor;
    const int index_accessor = json_.index("indices", accessors_.count(), "accessors");
    if (mode < k_triangles) return skipped("points and lines cast no shadow here");
    if (!accessor_of_.contains("POSITION")) return skipped("without POSITION there is nothing to draw");
    read_draco();
    check_counts();

    GltfPart result;
    result.place = json_.place();
    MeshPart& part = result.part;
    std::vector<uint32_t> indices = read_indices(index_accessor);
    const size_t left_over = mode == k_triangles ? indices.size() % 3 : indices.size() < 3 ? indices.size() : 0;
    if (left_over > 0) {
      log_warning("{}: {}: {} indices are no whole number of triangles; the last {} of them are left out", document_.name(),
                  index_accessor >= 0 ? json_.where("indices") : json_.place(), indices.size(), left_over);
    }
    part.indices = triangles_of(mode, std::move(indices));
    compact(part.indices);
    part.positions = attribute<3>("POSITION");
    read_directions(part);
    const std::string uv = fmt::format("TEXCOORD_{}", materials_.uv_set(material));
    if (has(uv)) part.uvs = attribute<2>(uv, &mended_.uvs);
    if (has("COLOR_0")) part.colours = colours();
    part.material = materials_.of_part(material, part, mesh_);
    for (const GltfValue& target : json_.objects("targets")) result.targets.push_back(read_target(target));
    if (has("JOINTS_0")) result.influences = read_influences();
    result.file_vertices = std::move(used_);
    return result;
  }

 private:
  std::optional<GltfPart> skipped(std::string_view why) const {
    log_warning("{}: {}: left out: {}", document_.name(), json_.place(), why);
    return std::nullopt;
  }
  std::string where(const std::string& attribute) const { return fmt::format("{}.attributes.{}", json_.place(), attribute); }
  bool has(const std::string& name) const { return draco_.attributes.contains(name) || accessor_of_.contains(name); }

  void read_draco() {
    const auto extension = json_.extension("KHR_draco_mesh_compression");
    if (!extension) return;
    const int view = extension->required_index("bufferView", document_.view_count(), "bufferViews");
    std::map<std::string, uint32_t> ids;
    for (const auto& [name, id] :
         extension->required_object("attributes").named_indices(1u << 16, "the attributes of the stream")) {
      ids[name] = static_cast<uint32_t>(id);
    }
    const std::string problem = decode_draco(document_.view(view, extension->where("bufferView")), ids, draco_);
    if (!problem.empty()) extension->fail_here("{}", problem);
    document_.budget().take(draco_.vertex_count + draco_.indices.size(), extension->place());
    is_draco_ = true;
  }

  void check_counts() {
    vertex_count_ = is_draco_ ? draco_.vertex_count : accessors_.element_count(accessor_of_.at("POSITION"));
    for (const auto& [name, accessor] : accessor_of_) {
      if (!draco_.attributes.contains(name)) require_count(accessor, where(name));
    }
  }

  void require_count(int accessor, const std::string& place) const {
    const size_t count = accessors_.element_count(accessor);
    if (count != vertex_count_)
      fail("{}: {}: has {} elements; valid: as many as POSITION, {}", document_.name(), place, count, vertex_count_);
  }

  std::vector<uint32_t> read_indices(int accessor) {
    if (is_draco_) return std::move(draco_.indices);
    if (accessor < 0) {
      document_.budget().take(vertex_count_, where("POSITION"));
      std::vector<uint32_t> all(vertex_count_);
      std::iota(all.begin(), all.end(), 0u);
      return all;
    }
    return accessors_.indices(accessor, json_.where("indices"));
  }

  // Those that are not finite or have no length are remade later (scene/finish_part.h).
  void read_directions(MeshPart& part) {
    size_t not_finite = 0;  // zero now, and counted as such
    if (has("NORMAL")) part.normals = attribute<3>("NORMAL", &not_finite);
    if (has("TANGENT")) part.tangents = attribute<4>("TANGENT", &not_finite);
    mended_.normals += without_length(part.normals);
    mended_.tangents += without_length(part.tangents);
  }

  MorphTarget read_target(const GltfValue& json) {
    MorphTarget target;
    for (const auto& [name, accessor] : json.named_indices(accessors_.count(), "accessors")) {
      std::vector<vec3>* values = name == "POSITION"  ? &target.positions
                                  : name == "NORMAL"  ? &target.normals
                                  : name == "TANGENT" ? &target.tangents
                                                      : nullptr;
      if (!values) {
        mended_.other_morphs = true;
        continue;
      }
      require_count(accessor, json.where(name));
      size_t* lost = name == "POSITION" ? nullptr : name == "NORMAL" ? &mended_.normals : &mended_.tangents;
      *values = accessors_.floats<3>(accessor, json.where(name), &used_, lost);
    }
    return target;
  }

  SkinInfluences read_influences() {
    SkinInfluences result;
    std::vector<std::vector<vec4>> joints, weights;
    for (size_t set = 0; has(fmt::format("JOINTS_{}", set)); ++set) {
      const std::string joint = fmt::format("JOINTS_{}", set), weight = fmt::format("WEIGHTS_{}", set);
      if (!has(weight)) json_.fail_in("attributes", "has {} without {}", joint, weight);
      if (const auto accessor = accessor_of_.find(joint);
          accessor != accessor_of_.end() && !accessors_.is_unsigned(accessor->second)) {
        fail("{}: {}: valid: unsigned integers that are not normalised", document_.name(), where(joint));
      }
      joints.push_back(attribute<4>(joint));
      weights.push_back(attribute<4>(weight));
    }
    result.per_vertex = 4 * joints.size();
    document_.budget().take(joints.size() * used_.size(), where("JOINTS_0"));
    for (size_t i = 0; i < used_.size(); ++i) {
      for (size_t set = 0; set < joints.size(); ++set) {
        for (int c = 0; c < 4; ++c) {
          result.joints.push_back(static_cast<uint32_t>(joints[set][i][c]));
          result.weights.push_back(std::max(weights[set][i][c], 0.0f));
        }
      }
    }
    mended_.without_weights += normalise(result);
    return result;
  }

  // Numbers the used vertices from 0 in their order of appearance in the buffer and remembers which they are.
  void compact(std::vector<uint32_t>& indices) {
    document_.budget().take(vertex_count_, where("POSITION"));
    std::vector<uint32_t> new_index(vertex_count_, 0);
    for (size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] >= vertex_count_)
        json_.fail_in("indices", "element {} is {}; there are {} vertices", i, indices[i], vertex_count_);
      new_index[indices[i]] = 1;
    }
    for (uint32_t vertex = 0; vertex < vertex_count_; ++vertex) {
      if (new_index[vertex] == 0) continue;
      new_index[vertex] = static_cast<uint32_t>(used_.size());
      used_.push_back(vertex);
    }
    for (uint32_t& index : indices) index = new_index[index];
  }

  // `lost`: counts values that are not finite, which become zero; without it they are an error.
  template <int N>
  std::vector<glm::vec<N, float>> attribute(const std::string& name, size_t* lost = nullptr) const {
    if (const auto draco = draco_.attributes.find(name); draco != draco_.attributes.end())
      return from_draco<N>(name, draco->second, lost);
    return accessors_.floats<N>(accessor_of_.at(name), where(name), &used_, lost);
  }

  template <int N>
  std::vector<glm::vec<N, float>> from_draco(const std::string& name, const DracoMesh::Attribute& attribute,
                                             size_t* lost) const {
    if (attribute.components != N) {
      fail("{}: {}: has {} components in the compressed data; valid: {}", document_.name(), where(name), attribute.components,
           N);
    }
    const float scale = attribute.normalised ? 1.0f : integer_scale(name);
    std::vector<glm::vec<N, float>> values(used_.size());
    for (size_t i = 0; i < used_.size(); ++i) {
      bool finite = true;
      for (int c = 0; c < N; ++c) {
        values[i][c] = attribute.values[size_t{used_[i]} * N + static_cast<size_t>(c)] * scale;
        finite = finite && std::isfinite(values[i][c]);
      }
      if (finite) continue;
      if (!lost) fail("{}: {}: element {} is not finite; valid: finite numbers", document_.name(), where(name), used_[i]);
      values[i] = glm::vec<N, float>(0.0f);
      ++*lost;
    }
    return values;
  }

  // Encoders do not all mark their integers as normalised; the accessor does.
  float integer_scale(const std::string& name) const {
    const auto accessor = accessor_of_.find(name);
    return accessor == accessor_of_.end() ? 1.0f : accessors_.normalised_scale(accessor->second);
  }

  std::vector<vec4> colours() {
    const auto draco = draco_.attributes.find("COLOR_0");
    const int components =
        draco != draco_.attributes.end() ? draco->second.components : accessors_.components(accessor_of_.at("COLOR_0"));
    if (components == 4) return attribute<4>("COLOR_0", &mended_.colours);
    std::vector<vec4> result;
    for (const vec3& colour : attribute<3>("COLOR_0", &mended_.colours)) result.emplace_back(colour, 1.0f);
    return result;
  }

  GltfDocument& document_;
  const GltfAccessors& accessors_;
  GltfMaterials& materials_;
  const GltfValue& json_;
  const std::string& mesh_;
  Mended& mended_;
  std::map<std::string, int> accessor_of_;
  DracoMesh draco_;
  bool is_draco_ = false;
  size_t vertex_count_ = 0;
  std::vector<uint32_t> used_;
};

void warn_of(const Mended& mended, const GltfDocument& document, const GltfValue& mesh) {
  const auto warn = [&](size_t count, const char* what) {
    if (count > 0) log_warning("{}: {} ('{}'): {} {}", document.name(), mesh.place(), mesh.text("name", ""), count, what);
  };
  warn(mended.normals, "normals are not finite or have no length; they are made from the faces");
  warn(mended.tangents, "tangents are not finite or have no length; they are made anew");
  warn(mended.uvs, "texture coordinates are not finite; they are 0 now");
  warn(mended.colours, "vertex colours are not finite; they are black now");
  warn(mended.without_weights, "vertices have no weights of joints; they follow their first joint");
  if (mended.other_morphs)
    log_warning("{}: {}: morph targets of texture coordinates and colours are not read", document.name(), mesh.place());
}

std::vector<float> read_weights(const GltfDocument& document, const GltfValue& mesh, const std::vector<GltfPart>& parts) {
  const std::vector<float> weights = mesh.floats("weights");
  const size_t targets = parts.empty() ? weights.size() : parts.front().targets.size();
  if (!weights.empty() && weights.size() != targets) {
    log_warning("{}: {}: has {} weights for {} morph targets; those that are missing are 0", document.name(), mesh.place(),
                weights.size(), targets);
  }
  return weights;
}

}  // namespace

std::vector<GltfMesh> read_gltf_meshes(GltfDocument& document, const GltfAccessors& accessors, const std::vector<bool>& shown,
                                       GltfMaterials& materials) {
  std::vector<GltfMesh> meshes;
  for (const GltfValue& json : document.root().objects("meshes")) {
    GltfMesh mesh;
    mesh.name = json.text("name", json.place());
    if (!shown[meshes.size()]) {
      meshes.push_back(std::move(mesh));
      continue;
    }
    Mended mended;
    for (const GltfValue& primitive : json.objects("primitives")) {
      check_cancelled();
      if (auto part = Primitive(document, accessors, materials, primitive, mesh.name, mended).read())
        mesh.parts.push_back(std::move(*part));
    }
    warn_of(mended, document, json);
    mesh.weights = read_weights(document, json, mesh.parts);
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

}  // namespace gnomon
