// Meshes of a glTF file as triangles: attributes, Draco data, strips and fans.
#include "scene/gltf/gltf_meshes.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/interrupt.h"
#include "base/log.h"
#include "scene/finish_part.h"
#include "scene/gltf/gltf_compression.h"
#include "scene/parallel.h"

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

// One primitive: finds out which vertices its triangles use, then reads only those. Files often share one large vertex
// buffer among hundreds of primitives.
class Primitive {
 public:
  Primitive(GltfDocument& document, const GltfAccessors& accessors, GltfMaterials& materials, const GltfValue& json)
      : document_(document), accessors_(accessors), materials_(materials), json_(json) {}

  // nullopt where there is nothing to draw as triangles.
  std::optional<MeshPart> read() {
    const auto mode = static_cast<Mode>(json_.integer("mode", k_triangles, k_points, k_fan));
    const int material = json_.index("material", document_.root().objects("materials").size(), "materials");
    const GltfValue attributes = json_.required_object("attributes");
    for (const auto& [name, accessor] : attributes.named_indices(accessors_.count(), "accessors"))
      accessor_of_[name] = accessor;
    const int index_accessor = json_.index("indices", accessors_.count(), "accessors");
    if (mode < k_triangles) return skipped("points and lines cast no shadow here");
    if (!accessor_of_.contains("POSITION")) return skipped("without POSITION there is nothing to draw");
    read_draco();
    check_counts();

    MeshPart part;
    part.material = material >= 0 ? material : materials_.default_material();
    part.indices = triangles_of(mode, read_indices(index_accessor));
    compact(part.indices);
    part.positions = attribute<3>("POSITION");
    if (has("NORMAL")) part.normals = attribute<3>("NORMAL");
    if (has("TANGENT")) part.tangents = attribute<4>("TANGENT");
    const std::string uv = fmt::format("TEXCOORD_{}", materials_.uv_set(material));
    if (has(uv)) part.uvs = attribute<2>(uv);
    if (has("COLOR_0")) part.colours = colours();
    return part;
  }

 private:
  std::optional<MeshPart> skipped(std::string_view why) const {
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
      if (draco_.attributes.contains(name)) continue;
      const size_t count = accessors_.element_count(accessor);
      if (count != vertex_count_) {
        fail("{}: {}: has {} elements; valid: as many as POSITION, {}", document_.name(), where(name), count, vertex_count_);
      }
    }
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

  template <int N>
  std::vector<glm::vec<N, float>> attribute(const std::string& name) const {
    if (const auto draco = draco_.attributes.find(name); draco != draco_.attributes.end())
      return from_draco<N>(name, draco->second);
    return accessors_.floats<N>(accessor_of_.at(name), where(name), &used_);
  }

  template <int N>
  std::vector<glm::vec<N, float>> from_draco(const std::string& name, const DracoMesh::Attribute& attribute) const {
    if (attribute.components != N) {
      fail("{}: {}: has {} components in the compressed data; valid: {}", document_.name(), where(name), attribute.components,
           N);
    }
    const float scale = attribute.normalised ? 1.0f : integer_scale(name);
    std::vector<glm::vec<N, float>> values(used_.size());
    for (size_t i = 0; i < used_.size(); ++i) {
      for (int c = 0; c < N; ++c) {
        values[i][c] = attribute.values[size_t{used_[i]} * N + static_cast<size_t>(c)] * scale;
        if (!std::isfinite(values[i][c]))
          fail("{}: {}: element {} is not finite; valid: finite numbers", document_.name(), where(name), used_[i]);
      }
    }
    return values;
  }

  // Encoders do not all mark their integers as normalised; the accessor does.
  float integer_scale(const std::string& name) const {
    const auto accessor = accessor_of_.find(name);
    return accessor == accessor_of_.end() ? 1.0f : accessors_.normalised_scale(accessor->second);
  }

  std::vector<vec4> colours() const {
    const auto draco = draco_.attributes.find("COLOR_0");
    const int components =
        draco != draco_.attributes.end() ? draco->second.components : accessors_.components(accessor_of_.at("COLOR_0"));
    if (components == 4) return attribute<4>("COLOR_0");
    std::vector<vec4> result;
    for (const vec3& colour : attribute<3>("COLOR_0")) result.emplace_back(colour, 1.0f);
    return result;
  }

  GltfDocument& document_;
  const GltfAccessors& accessors_;
  GltfMaterials& materials_;
  const GltfValue& json_;
  std::map<std::string, int> accessor_of_;
  DracoMesh draco_;
  bool is_draco_ = false;
  size_t vertex_count_ = 0;
  std::vector<uint32_t> used_;
};

}  // namespace

std::vector<Mesh> read_gltf_meshes(GltfDocument& document, const GltfAccessors& accessors, GltfMaterials& materials) {
  std::vector<Mesh> meshes;
  for (const GltfValue& json : document.root().objects("meshes")) {
    Mesh mesh;
    mesh.name = json.text("name", json.place());
    for (const GltfValue& primitive : json.objects("primitives")) {
      check_cancelled();
      if (auto part = Primitive(document, accessors, materials, primitive).read()) mesh.parts.push_back(std::move(*part));
    }
    meshes.push_back(std::move(mesh));
  }
  std::vector<MeshPart*> parts;
  for (Mesh& mesh : meshes) {
    for (MeshPart& part : mesh.parts) parts.push_back(&part);
  }
  Progress progress("preparing " + document.name(), parts.size());
  parallel_for(parts.size(), progress, [&](size_t i) { finish_part(*parts[i]); });
  return meshes;
}

}  // namespace gnomon
