// From the faces of an OBJ file to triangles with one index per vertex.
#include "scene/obj/obj_mesh.h"

#include <bit>
#include <utility>

#include "base/interrupt.h"
#include "scene/finish_part.h"

namespace gnomon {
namespace {

constexpr size_t k_corners_between_checks = size_t{1} << 16;  // for a cancellation

// Numbers distinct corners in their order of appearance. Open addressing: std::unordered_map takes a third of the loading time.
class CornerTable {
 public:
  explicit CornerTable(size_t corner_count) : slots_(std::bit_ceil(2 * corner_count + 1)) {}

  std::pair<uint32_t, bool> insert(const ObjCorner& c) {
    for (size_t slot = hash(c);; ++slot) {
      Slot& s = slots_[slot & (slots_.size() - 1)];
      if (s.corner == c) return {s.number, false};
      if (s.corner.position != k_absent) continue;
      s = {c, count_++};
      return {s.number, true};
    }
  }

 private:
  struct Slot {
    ObjCorner corner;  // position k_absent: free
    uint32_t number = 0;
  };
  static size_t hash(const ObjCorner& c) {
    uint64_t bits = static_cast<uint32_t>(c.position);
    for (const int32_t more : {c.uv, c.normal}) bits = bits * 0x9e3779b97f4a7c15ull + static_cast<uint32_t>(more);
    bits *= 0x9e3779b97f4a7c15ull;
    return static_cast<size_t>(bits ^ bits >> 32);
  }

  std::vector<Slot> slots_;
  uint32_t count_ = 0;
};

void add_vertex(MeshPart& part, const ObjVertices& vertices, const ObjCorner& c) {
  const auto position = static_cast<size_t>(c.position);
  part.positions.push_back(vertices.positions[position]);
  part.uvs.push_back(c.uv == k_absent ? vec2(0.0f) : vertices.uvs[static_cast<size_t>(c.uv)]);
  if (c.normal != k_absent) part.normals.push_back(vertices.normals[static_cast<size_t>(c.normal)]);
  if (!vertices.colours.empty())
    part.colours.push_back(position < vertices.colours.size() ? vertices.colours[position] : vec4(1.0f));
}

}  // namespace

MeshPart build_obj_part(const ObjVertices& vertices, const ObjFaces& faces) {
  MeshPart part;
  part.material = faces.material;
  part.indices.reserve(faces.corners.size());
  CornerTable numbers(faces.corners.size());
  for (const ObjCorner& c : faces.corners) {
    const auto [vertex, is_new] = numbers.insert(c);
    if (is_new) add_vertex(part, vertices, c);
    part.indices.push_back(vertex);
    if (part.indices.size() % k_corners_between_checks == 0) check_cancelled();
  }
  finish_part(part);
  return part;
}

}  // namespace gnomon
