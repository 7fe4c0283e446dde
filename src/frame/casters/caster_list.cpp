// Ranges, chunks, upload.
#include "frame/casters/caster_list.h"

#include <algorithm>

#include "frame/upload_vector.h"

namespace gnomon {
namespace {

Box world_bounds(const DrawItem& item, std::span<const vec3> positions, std::span<const uint32_t> indices) {
  Box box;
  for (const uint32_t index : indices) {
    const vec4 p(positions[item.first_vertex + index], 1.0f);
    box.add(
        {glm::dot(item.world_from_object_x, p), glm::dot(item.world_from_object_y, p), glm::dot(item.world_from_object_z, p)});
  }
  return box;
}

struct Group {
  std::vector<Box> members;
  Box bounds, centres;
  void add(const Box& box) {
    members.push_back(box);
    bounds.add(box);
    centres.add(box.centre());
  }
  // What halving it could shorten; 0: nothing.
  float longest_side() const {
    const vec3 extent = bounds.extent(), between = centres.extent();
    return between == vec3(0.0f) ? 0.0f : std::max({extent.x, extent.y, extent.z});
  }
};

// The group with the longest side is halved, while there may be more groups.
std::vector<Box> make_groups(std::span<const CasterRange> ranges) {
  std::vector<Group> groups(1);
  for (const CasterRange& range : ranges) groups[0].add({range.bounds_min_ws, range.bounds_max_ws});
  while (groups.size() < k_caster_groups) {
    const auto shorter = [](const Group& a, const Group& b) { return a.longest_side() < b.longest_side(); };
    Group& whole = *std::max_element(groups.begin(), groups.end(), shorter);
    if (whole.longest_side() == 0.0f) break;
    const vec3 extent = whole.centres.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    Group halves[2];
    for (const Box& box : whole.members) halves[box.centre()[axis] > whole.centres.centre()[axis]].add(box);
    // Two floats that are neighbours have no middle between them.
    if (halves[0].members.empty() || halves[1].members.empty()) break;
    whole = std::move(halves[0]);
    groups.push_back(std::move(halves[1]));
  }
  std::vector<Box> boxes;
  for (const Group& group : groups) {
    if (!group.members.empty()) boxes.push_back(group.bounds);
  }
  return boxes;
}

}  // namespace

CasterList make_caster_list(Device& device, std::span<const DrawItem> items, std::span<const vec3> positions,
                            std::span<const uint32_t> indices, std::span<const uint32_t> bucket_ends, bool clusters) {
  CasterList list;
  std::vector<CasterRange> ranges;
  std::vector<CasterChunk> chunks;
  uint32_t item = 0;
  for (uint32_t b = 0; b < k_bucket_count; ++b) {
    list.begin[b] = static_cast<uint32_t>(ranges.size());
    for (; item < bucket_ends[b]; ++item) {
      const DrawItem& draw = items[item];
      if (!(draw.flags & k_item_casts)) continue;
      const uint32_t step = clusters ? 3 * k_cluster_triangles : draw.index_count;
      for (uint32_t first = 0; first < draw.index_count; first += step) {
        const uint32_t count = std::min(step, draw.index_count - first);
        // The item's own bounds are those of its object's box, which is looser.
        const Box box = clusters ? world_bounds(draw, positions, indices.subspan(draw.first_index + first, count))
                                 : Box{draw.bounds_min_ws, draw.bounds_max_ws};
        ranges.push_back({box.min, draw.first_index + first, box.max, count, item});
      }
    }
    list.end[b] = static_cast<uint32_t>(ranges.size());
    const auto first_chunk = static_cast<uint32_t>(chunks.size());
    const uint32_t in_bucket = (list.end[b] - list.begin[b] + k_caster_chunk - 1) / k_caster_chunk;
    for (uint32_t c = 0; c < in_bucket; ++c) {
      const uint32_t begin = list.begin[b] + c * k_caster_chunk;
      chunks.push_back({b, begin, std::min(begin + k_caster_chunk, list.end[b]), first_chunk, first_chunk + in_bucket - 1});
    }
  }
  list.range_count = static_cast<uint32_t>(ranges.size());
  list.chunk_count = static_cast<uint32_t>(chunks.size());
  list.ranges = upload_vector(device, clusters ? "caster clusters" : "casters", ranges);
  list.chunks = upload_vector(device, "caster chunks", chunks);
  list.groups = make_groups(ranges);
  return list;
}

}  // namespace gnomon
