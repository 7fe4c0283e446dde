// Upload of geometry and materials.
#include "frame/gpu_scene.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "frame/glsl/octahedral.glsl"
#include "frame/texture_upload.h"
#include "frame/upload_vector.h"
#include "scene/ray_extents.h"
#include "scene/subject.h"

namespace gnomon {
namespace {

constexpr size_t k_max_id = size_t{1} << 24;  // ids travel as floats through the surface attachments

uint32_t pack_colour(const vec4& colour) {
  uint32_t packed = 0;
  for (int i = 0; i < 4; ++i)
    packed |= static_cast<uint32_t>(std::lround(glm::clamp(colour[i], 0.0f, 1.0f) * 255.0f)) << (8 * i);
  return packed;
}

VertexAttributes pack_vertex(const MeshPart& part, size_t i) {
  const vec4& tangent = part.tangents[i];
  const uint32_t handedness = tangent.w < 0.0f ? 1u : 0u;
  return {part.uvs[i], pack_normal(part.normals[i]), (pack_normal(vec3(tangent)) & ~1u) | handedness,
          pack_colour(part.colours[i])};
}

}  // namespace

GpuScene::GpuScene(Device& device, const Scene& scene) : device_(device), scene_(scene) {
  bounds_ = shadowed_bounds(scene);
  ray_extents_ = gnomon::ray_extents(scene);
  upload_textures();
  upload_materials();
  upload_geometry();
}

SceneData GpuScene::data() const {
  return {items_.address(), positions_.address(), attributes_.address(), indices_.address(), materials_.address()};
}

void GpuScene::upload_textures() {
  for (const Texture& texture : scene_.textures) textures_.push_back(upload_texture(device_, texture));
}

void GpuScene::upload_materials() {
  std::vector<MaterialData> list;
  const auto sampler = [&](int texture, uint32_t filtering) {
    if (texture == k_no_texture) return 0u;
    const Texture& t = scene_.textures[static_cast<size_t>(texture)];
    return material_sampler(filtering, static_cast<uint32_t>(t.wrap_u), static_cast<uint32_t>(t.wrap_v));
  };
  const auto index = [&](int texture) {
    return texture == k_no_texture ? k_no_texture_index : textures_[static_cast<size_t>(texture)].sampled();
  };
  for (const Material& material : scene_.materials) {
    MaterialData data = {};
    data.base_colour = material.base_colour;
    data.base_uv_u = material.base_colour_uv.row_u;
    data.base_uv_v = material.base_colour_uv.row_v;
    data.normal_uv_u = material.normal_uv.row_u;
    data.normal_uv_v = material.normal_uv.row_v;
    data.base_texture = index(material.base_colour_texture);
    data.caster_texture = index(material.caster_texture());
    data.normal_texture = index(material.normal_texture);
    // A CPU draws half as fast again without anisotropy. Where the texture decides what is seen, every device has to agree.
    const uint32_t filtering = device_.info().software ? k_material_trilinear : k_material_anisotropic;
    data.base_sampler = sampler(material.base_colour_texture, material.masked ? k_material_anisotropic : filtering);
    data.normal_sampler = sampler(material.normal_texture, filtering);
    if (material.base_colour_texture != k_no_texture) {
      const Texture& texture = scene_.textures[static_cast<size_t>(material.base_colour_texture)];
      data.base_wrap_u = static_cast<uint32_t>(texture.wrap_u);
      data.base_wrap_v = static_cast<uint32_t>(texture.wrap_v);
    }
    data.seen_cutoff = material.seen_cutoff();
    data.caster_cutoff = material.caster_cutoff();
    data.normal_scale = material.normal_scale;
    data.shininess = material.shininess;
    data.specular = material.specular;
    data.emissive = material.emissive;
    list.push_back(data);
  }
  materials_ = upload_vector(device_, "materials", list);
}

void GpuScene::upload_geometry() {
  std::vector<vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
  struct PartRange {
    uint32_t first_index, first_vertex;
    Box bounds;
  };
  std::vector<std::vector<PartRange>> ranges(scene_.meshes.size());
  for (size_t m = 0; m < scene_.meshes.size(); ++m) {
    for (const MeshPart& part : scene_.meshes[m].parts) {
      if (part.triangle_count() >= k_max_id)
        fail("mesh '{}': {} triangles in one part; at most {} are supported", scene_.meshes[m].name, part.triangle_count(),
             k_max_id);
      PartRange range = {static_cast<uint32_t>(indices.size()), static_cast<uint32_t>(positions.size()), {}};
      for (const uint32_t vertex : part.indices) range.bounds.add(part.positions[vertex]);
      ranges[m].push_back(range);
      positions.insert(positions.end(), part.positions.begin(), part.positions.end());
      indices.insert(indices.end(), part.indices.begin(), part.indices.end());
      for (size_t i = 0; i < part.positions.size(); ++i) attributes.push_back(pack_vertex(part, i));
    }
  }
  if (positions.size() > 0xffffffffu || indices.size() > 0xffffffffu)
    fail("{}: more than 2^32 vertices or indices", scene_.name);

  std::vector<std::vector<DrawItem>> by_bucket(k_bucket_count);
  for (size_t o = 0; o < scene_.objects.size(); ++o) {
    const Object& object = scene_.objects[o];
    const mat4& m = object.world_from_object;
    const mat4 rows = glm::transpose(m);
    const bool mirrored = glm::determinant(mat3(m)) < 0.0f;
    const Mesh& mesh = scene_.meshes[static_cast<size_t>(object.mesh)];
    for (size_t p = 0; p < mesh.parts.size(); ++p) {
      const MeshPart& part = mesh.parts[p];
      if (part.indices.empty()) continue;
      const PartRange& range = ranges[static_cast<size_t>(object.mesh)][p];
      const Material& material = scene_.materials[static_cast<size_t>(part.material)];
      const Box box = transformed(m, range.bounds);
      DrawItem item = {};
      item.world_from_object_x = rows[0], item.world_from_object_y = rows[1], item.world_from_object_z = rows[2];
      item.bounds_min_ws = box.min, item.bounds_max_ws = box.max;
      item.first_index = range.first_index, item.first_vertex = range.first_vertex;
      item.index_count = static_cast<uint32_t>(part.indices.size());
      item.material = static_cast<uint32_t>(part.material);
      item.object = static_cast<uint32_t>(o);
      const bool casts = part_casts(object, material);
      item.flags = (casts ? k_item_casts : 0u) | (mirrored ? k_item_mirrored : 0u);
      const uint32_t bucket = (material.caster_cutoff() >= 0.0f ? Bucket::k_masked : 0) |
                              (material.double_sided ? Bucket::k_double_sided : 0) | (mirrored ? Bucket::k_mirrored : 0);
      by_bucket[bucket].push_back(item);
      if (casts) caster_triangles_ += part.triangle_count(), caster_bounds_.add(box);
    }
  }
  for (uint32_t b = 0; b < k_bucket_count; ++b) {
    buckets_[b].begin = static_cast<uint32_t>(item_list_.size());
    item_list_.insert(item_list_.end(), by_bucket[b].begin(), by_bucket[b].end());
    buckets_[b].end = static_cast<uint32_t>(item_list_.size());
  }
  if (item_list_.empty()) fail("{}: nothing to draw: the scene has no triangles", scene_.file_or_name());
  if (item_list_.size() >= k_max_id) fail("{}: {} objects; at most {} are supported", scene_.name, item_list_.size(), k_max_id);

  const VkBufferUsageFlags build_input =
      device_.info().ray_tracing ? VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR : 0;
  vertex_count_ = positions.size();
  positions_ = upload_vector(device_, "positions", positions, build_input);
  attributes_ = upload_vector(device_, "vertex attributes", attributes);
  indices_ = upload_vector(device_, "indices", indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT | build_input);
  items_ = upload_vector(device_, "draw items", item_list_);
  std::array<uint32_t, k_bucket_count> ends;
  for (uint32_t b = 0; b < k_bucket_count; ++b) ends[b] = buckets_[b].end;
  caster_items_ = make_caster_list(device_, item_list_, positions, indices, ends, false);
  caster_clusters_ = make_caster_list(device_, item_list_, positions, indices, ends, true);
}

}  // namespace gnomon
