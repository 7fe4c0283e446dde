// What files leave out of a mesh (normals, tangents), and what makes it fast to draw.
#include "scene/mesh_tools.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;

// Twice the triangle's area along its normal. Double precision: neither overflow nor, in practice, cancellation.
dvec3 area_vector(const vec3& a, const vec3& b, const vec3& c) { return glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a)); }

// --- normals ---------------------------------------------------------------------------------------------------------

// One number per distinct position (uv seams and hard edges in the file must not split the smoothing).
std::vector<uint32_t> position_ids(const std::vector<vec3>& positions) {
  std::vector<vec3> unsigned_zero(positions.size());
  for (size_t i = 0; i < positions.size(); ++i) unsigned_zero[i] = positions[i] + 0.0f;  // -0 and +0 are one place
  std::vector<uint32_t> ids(positions.size());
  meshopt_generateVertexRemap(ids.data(), nullptr, positions.size(), unsigned_zero.data(), positions.size(), sizeof(vec3));
  return ids;
}

// Sets of triangle corners that share a normal.
class CornerSets {
 public:
  explicit CornerSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  uint32_t root(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(uint32_t a, uint32_t b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<uint32_t> parent_;
};

// Calls work(begin, end) for each run of items with one key; items within a run keep their order. A counting sort: with
// millions of triangles, a comparison sort of everything is most of the loading time.
template <class Work>
void for_each_group(const std::vector<uint32_t>& keys, uint32_t key_count, const Work& work) {
  std::vector<uint32_t> end_of(key_count + 1, 0), items(keys.size());
  for (const uint32_t key : keys) ++end_of[key + 1];
  std::partial_sum(end_of.begin(), end_of.end(), end_of.begin());
  for (uint32_t i = 0; i < keys.size(); ++i) items[end_of[keys[i]]++] = i;
  for (size_t begin = 0, key = 0; key < key_count; begin = end_of[key++]) {
    check_cancelled();
    work(items.begin() + begin, items.begin() + end_of[key]);
  }
}

// Equal keys in ascending order of the items: the outcome must not depend on the sort.
template <class Iterator, class Key>
void sort_by(Iterator begin, Iterator end, const Key& key) {
  std::sort(begin, end, [&](uint32_t a, uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
}

constexpr uint32_t next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

CornerSets smooth_sets(const MeshPart& part, const std::vector<dvec3>& areas, float crease_angle) {
  const auto ids = position_ids(part.positions);
  const double least_cosine = std::cos(static_cast<double>(crease_angle));
  const auto smooth = [&](uint32_t a, uint32_t b) {
    const double lengths = glm::length(areas[a]) * glm::length(areas[b]);
    return lengths == 0.0 || glm::dot(areas[a], areas[b]) >= least_cosine * lengths;
  };
  // An edge is named by the corner where it starts and belongs to the end with the lower id.
  const auto id_of = [&](uint32_t corner) { return ids[part.indices[corner]]; };
  const auto low = [&](uint32_t edge) { return id_of(edge) <= id_of(next_corner(edge)) ? edge : next_corner(edge); };
  const auto high = [&](uint32_t edge) { return id_of(edge) <= id_of(next_corner(edge)) ? next_corner(edge) : edge; };
  std::vector<uint32_t> low_ids(part.indices.size());
  for (uint32_t edge = 0; edge < low_ids.size(); ++edge) low_ids[edge] = id_of(low(edge));
  CornerSets sets(part.indices.size());
  for_each_group(low_ids, static_cast<uint32_t>(ids.size()), [&](auto begin, auto end) {
    sort_by(begin, end, [&](uint32_t edge) { return id_of(high(edge)); });
    for (auto edge = begin; edge != end && edge + 1 != end; ++edge) {
      const uint32_t a = edge[0], b = edge[1];
      if (id_of(high(a)) != id_of(high(b)) || !smooth(a / 3, b / 3)) continue;
      sets.join(low(a), low(b));
      sets.join(high(a), high(b));
    }
  });
  return sets;
}

vec3 unit_or_up(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? vec3(v / length) : vec3(0, 1, 0);
}

template <class T>
void append_copy(std::vector<T>& values, uint32_t index) {
  if (index < values.size()) values.push_back(T(values[index]));
}

}  // namespace

void make_normals(MeshPart& part, float crease_angle) {
  GNOMON_ASSERT(part.indices.size() % 3 == 0 && part.indices.size() < 0xffffffffu);
  std::vector<dvec3> areas(part.triangle_count());
  for (size_t t = 0; t < areas.size(); ++t) {
    const uint32_t* i = &part.indices[3 * t];
    areas[t] = area_vector(part.positions[i[0]], part.positions[i[1]], part.positions[i[2]]);
  }
  CornerSets sets = smooth_sets(part, areas, crease_angle);
  std::vector<dvec3> sums(part.indices.size(), dvec3(0.0));
  for (uint32_t corner = 0; corner < part.indices.size(); ++corner) sums[sets.root(corner)] += areas[corner / 3];

  // Corners of one vertex side by side, and among them those of one set; the first set keeps the vertex, others get copies.
  const auto vertex_count = static_cast<uint32_t>(part.positions.size());
  const std::vector<uint32_t> old_indices = part.indices;
  part.normals.assign(vertex_count, vec3(0, 1, 0));
  for_each_group(old_indices, vertex_count, [&](auto begin, auto end) {
    sort_by(begin, end, [&](uint32_t corner) { return sets.root(corner); });
    for (auto corner = begin; corner != end; ++corner) {
      const uint32_t vertex = old_indices[*corner];
      const bool new_set = corner != begin && sets.root(*corner) != sets.root(corner[-1]);
      if (new_set) {
        append_copy(part.positions, vertex), append_copy(part.tangents, vertex), append_copy(part.uvs, vertex);
        append_copy(part.colours, vertex), append_copy(part.normals, vertex);
      }
      part.indices[*corner] = corner == begin ? vertex
                              : new_set       ? static_cast<uint32_t>(part.positions.size() - 1)
                                              : part.indices[corner[-1]];
      part.normals[part.indices[*corner]] = unit_or_up(sums[sets.root(*corner)]);
    }
  });
}

// --- tangents --------------------------------------------------------------------------------------------------------

void make_tangents(MeshPart& part) {
  GNOMON_ASSERT(part.normals.size() == part.positions.size() && part.uvs.size() == part.positions.size());
  std::vector<dvec3> along_u(part.positions.size(), dvec3(0.0)), along_v(along_u);
  for (size_t t = 0; t < part.triangle_count(); ++t) {
    const uint32_t* i = &part.indices[3 * t];
    const dvec3 edge1 = dvec3(part.positions[i[1]]) - dvec3(part.positions[i[0]]);
    const dvec3 edge2 = dvec3(part.positions[i[2]]) - dvec3(part.positions[i[0]]);
    const dvec2 uv1 = dvec2(part.uvs[i[1]]) - dvec2(part.uvs[i[0]]), uv2 = dvec2(part.uvs[i[2]]) - dvec2(part.uvs[i[0]]);
    const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    if (determinant == 0.0) continue;
    // Lengyel divides by the determinant; its sign is enough, and weights by area instead of favouring tiny uv triangles.
    const double sign = determinant > 0.0 ? 1.0 : -1.0;
    const dvec3 u = sign * (uv2.y * edge1 - uv1.y * edge2), v = sign * (uv1.x * edge2 - uv2.x * edge1);
    for (int k = 0; k < 3; ++k) along_u[i[k]] += u, along_v[i[k]] += v;
  }
  part.tangents.resize(part.positions.size());
  for (size_t i = 0; i < part.positions.size(); ++i) {
    const dvec3 normal(part.normals[i]);
    const dvec3 tangent = along_u[i] - normal * glm::dot(normal, along_u[i]);
    const double length = glm::length(tangent);
    if (!(length > 1e-6 * glm::length(along_u[i]))) {
      vec3 any, unused;
      orthonormal_basis(part.normals[i], any, unused);
      part.tangents[i] = vec4(any, 1.0f);
      continue;
    }
    // The bitangent points to the top of the picture, against v.
    const bool right_handed = glm::dot(glm::cross(normal, tangent), -along_v[i]) >= 0.0;
    part.tangents[i] = vec4(vec3(tangent / length), right_handed ? 1.0f : -1.0f);
  }
}

// --- optimise --------------------------------------------------------------------------------------------------------

namespace {

// Whether the six terms sum to zero exactly: Shewchuk's (1997) expansion grown term by term; each addition keeps its error.
bool sum_is_zero(const std::array<double, 6>& terms) {
  double expansion[6];
  int size = 0;
  for (double q : terms) {
    for (int i = 0; i < size; ++i) {
      const double e = expansion[i], sum = q + e, b = sum - q;
      expansion[i] = (q - (sum - b)) + (e - b);
      q = sum;
    }
    expansion[size++] = q;
  }
  return std::all_of(expansion, expansion + size, [](double e) { return e == 0.0; });
}

// Whether three points are on a line when seen along an axis. The product of two floats is exact in double.
bool collinear(double ax, double ay, double bx, double by, double cx, double cy) {
  return sum_is_zero({ax * by, -ay * bx, bx * cy, -by * cx, cx * ay, -cy * ax});
}

bool zero_area(const vec3& a, const vec3& b, const vec3& c) {
  // Far above any rounding error of the double arithmetic, the cheap answer stands.
  const dvec3 area = area_vector(a, b, c);
  const double reach = std::max({glm::length(dvec3(a)), glm::length(dvec3(b)), glm::length(dvec3(c))});
  if (glm::length(area) > 1e-14 * reach * reach) return false;
  return collinear(a.x, a.y, b.x, b.y, c.x, c.y) && collinear(a.y, a.z, b.y, b.z, c.y, c.z) &&
         collinear(a.z, a.x, b.z, b.x, c.z, c.x);
}

void drop_degenerate(MeshPart& part) {
  size_t kept = 0;
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    const uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
    if (a == b || b == c || c == a || zero_area(part.positions[a], part.positions[b], part.positions[c])) continue;
    part.indices[kept++] = a, part.indices[kept++] = b, part.indices[kept++] = c;
  }
  part.indices.resize(kept);
}

template <class T>
void remap(std::vector<T>& values, const std::vector<uint32_t>& table, size_t new_count) {
  std::vector<T> result(new_count);
  meshopt_remapVertexBuffer(result.data(), values.data(), values.size(), sizeof(T), table.data());
  values = std::move(result);
}

// Moves vertices to where `table` says; those that no triangle uses are gone.
void remap_vertices(MeshPart& part, const std::vector<uint32_t>& table, size_t new_count) {
  for (uint32_t& index : part.indices) index = table[index];
  remap(part.positions, table, new_count);
  remap(part.normals, table, new_count);
  remap(part.tangents, table, new_count);
  remap(part.uvs, table, new_count);
  remap(part.colours, table, new_count);
}

}  // namespace

void optimise(MeshPart& part) {
  const size_t count = part.positions.size();
  GNOMON_ASSERT(part.normals.size() == count && part.tangents.size() == count && part.uvs.size() == count &&
                part.colours.size() == count);
  drop_degenerate(part);
  if (part.indices.empty()) {
    part = MeshPart{
        .positions = {}, .normals = {}, .tangents = {}, .uvs = {}, .colours = {}, .indices = {}, .material = part.material};
    return;
  }
  const meshopt_Stream streams[] = {{part.positions.data(), sizeof(vec3), sizeof(vec3)},
                                    {part.normals.data(), sizeof(vec3), sizeof(vec3)},
                                    {part.tangents.data(), sizeof(vec4), sizeof(vec4)},
                                    {part.uvs.data(), sizeof(vec2), sizeof(vec2)},
                                    {part.colours.data(), sizeof(vec4), sizeof(vec4)}};
  std::vector<uint32_t> table(count);
  const size_t unique = meshopt_generateVertexRemapMulti(table.data(), part.indices.data(), part.indices.size(), count, streams,
                                                         std::size(streams));
  remap_vertices(part, table, unique);

  check_cancelled();
  meshopt_optimizeVertexCache(part.indices.data(), part.indices.data(), part.indices.size(), unique);
  check_cancelled();
  table.resize(unique);
  const size_t used = meshopt_optimizeVertexFetchRemap(table.data(), part.indices.data(), part.indices.size(), unique);
  remap_vertices(part, table, used);
}

}  // namespace gnomon
