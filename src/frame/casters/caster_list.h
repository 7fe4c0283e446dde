// A scene's casters as what culling tests: whole items, or clusters of their triangles.
#pragma once

#include <array>
#include <vector>

#include "base/maths.h"
#include "frame/casters/caster_data.glsl"
#include "gpu/buffer.h"

namespace gnomon {

class GpuScene;

struct CasterList {
  // Of each bucket: ranges [begin, end).
  std::array<uint32_t, k_bucket_count> begin = {}, end = {};
  uint32_t range_count = 0, chunk_count = 0;
  Buffer ranges, chunks;
  // Boxes that hold all ranges, at most k_caster_groups: few enough for the CPU to look at in every frame, however large the
  // scene.
  std::vector<Box> groups;
};
inline constexpr size_t k_caster_groups = 64;

// Triangles of a cluster: consecutive ones of the cache-optimised index buffer lie close together.
inline constexpr uint32_t k_cluster_triangles = 128;

// One range per item that casts, or one per cluster of it. `positions` and `indices` are the scene's, on the CPU.
CasterList make_caster_list(Device& device, std::span<const DrawItem> items, std::span<const vec3> positions,
                            std::span<const uint32_t> indices, std::span<const uint32_t> bucket_ends, bool clusters);

}  // namespace gnomon
