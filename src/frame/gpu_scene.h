// A scene on the GPU: one vertex and one index buffer, draw items sorted into buckets, materials, textures.
#pragma once

#include <array>
#include <vector>

#include "frame/casters/caster_list.h"
#include "frame/casters/culling/cull_data.glsl"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "scene/scene.h"

namespace gnomon {

// Items of one bucket are drawn with the same pipeline and state. Masked: as casters.
struct Bucket {
  static constexpr uint32_t k_masked = 1, k_double_sided = 2, k_mirrored = 4;
  uint32_t begin = 0, end = 0;  // items
};

class GpuScene {
 public:
  // Uploads everything, with mipmaps. Throws Error when the scene exceeds what ids can count (2^24 items or triangles a part).
  GpuScene(Device& device, const Scene& scene);

  const Scene& scene() const { return scene_; }
  SceneData data() const;  // addresses for shaders
  const Buffer& indices() const { return indices_; }
  const Buffer& positions() const { return positions_; }
  const Buffer& items() const { return items_; }
  uint32_t item_count() const { return static_cast<uint32_t>(item_list_.size()); }
  const std::vector<DrawItem>& item_list() const { return item_list_; }
  const Bucket& bucket(uint32_t index) const { return buckets_[index]; }
  size_t vertex_count() const { return vertex_count_; }
  // What shadow maps draw: items or their clusters.
  const CasterList& casters(bool clusters) const { return clusters ? caster_clusters_ : caster_items_; }
  const CasterList& caster_clusters() const { return caster_clusters_; }
  // Triangles of the items that cast, as the rasteriser draws them.
  size_t caster_triangles() const { return caster_triangles_; }
  const Box& caster_bounds() const { return caster_bounds_; }
  const Box& bounds() const { return bounds_; }
  vec2 ray_extents() const { return ray_extents_; }  // for ray_origin (base/glsl/sampling.glsl)

 private:
  void upload_geometry();
  void upload_textures();
  void upload_materials();

  Device& device_;
  const Scene& scene_;
  Buffer positions_, attributes_, indices_, items_, materials_;
  std::vector<Image> textures_;
  std::vector<DrawItem> item_list_;
  std::array<Bucket, k_bucket_count> buckets_;
  CasterList caster_items_, caster_clusters_;
  size_t vertex_count_ = 0, caster_triangles_ = 0;
  Box bounds_, caster_bounds_;
  vec2 ray_extents_ = vec2(0.0f);
};

}  // namespace gnomon
