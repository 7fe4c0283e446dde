// Pieces of a scene - level sheets, steep triangles - and which of them count.
#include "scene/subject.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/casting.h"

namespace gnomon {
namespace {

// A scene of more triangles is taken apart only where its objects are wide enough to be its ground.
constexpr size_t k_many = size_t{1} << 18, k_most = size_t{1} << 20;
constexpr float k_level = 0.5f;  // cosine: what is steeper than 60 degrees is a wall, not ground
constexpr float k_flat = 0.05f;  // height over width of what may be ground: more is a landscape, and worth seeing
constexpr float k_wider = 2.5f;  // how much wider than all that stands on it the ground is that is left out
// Farther out than the rest by that: a stray, where it is little beside the rest, and where it is up to half of all.
constexpr float k_far = 30.0f, k_farther = 100.0f;
constexpr double k_little = 0.1;

// A level sheet, a steep triangle, or an object as a whole.
struct Item {
  Box box;
  size_t object = 0;
  size_t piece = 0;     // what hangs together has the same number
  bool sheet = false;   // level and flat
  double weight = 0.0;  // those of an object add up to the square root of its triangles: one statue of a million is not all
  bool counts = true;
};

float width(const Box& box) { return std::max(box.extent().x, box.extent().z); }
bool is_flat(const Box& box) { return box.extent().y <= k_flat * width(box) && width(box) > 0.0f; }

// Sets of numbers that were joined.
class Sets {
 public:
  explicit Sets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  uint32_t find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(uint32_t a, uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<uint32_t> parent_;
};

// The triangles of an object, in the world. Vertices at one place are one: seams and parts do not divide a surface.
struct Triangles {
  std::vector<vec3> positions;
  std::vector<uint32_t> indices;

  Triangles(const Mesh& mesh, const mat4& world_from_object) {
    std::vector<vec3> own;
    std::vector<uint32_t> apart;
    for (const MeshPart& part : mesh.parts) {
      const auto first = static_cast<uint32_t>(own.size());
      for (const vec3& p : part.positions) own.push_back(p + vec3(0.0f));  // -0 is 0
      for (const uint32_t i : part.indices) apart.push_back(first + i);
    }
    std::vector<uint32_t> table(own.size());
    const size_t count =
        meshopt_generateVertexRemap(table.data(), apart.data(), apart.size(), own.data(), own.size(), sizeof(vec3));
    positions.resize(count);
    for (size_t i = 0; i < own.size(); ++i) {
      if (table[i] < count) positions[table[i]] = vec3(world_from_object * vec4(own[i], 1.0f));
    }
    for (const uint32_t i : apart) indices.push_back(table[i]);
  }
  Box box(size_t first) const {
    Box box;
    for (size_t k = 0; k < 3; ++k) box.add(positions[indices[first + k]]);
    return box;
  }
  bool level(size_t first) const {
    const glm::dvec3 a(positions[indices[first]]), b(positions[indices[first + 1]]), c(positions[indices[first + 2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return std::abs(normal.y) >= k_level * glm::length(normal);
  }
};

class Items {
 public:
  explicit Items(const Scene& scene) : scene_(scene) {
    const bool many = scene.triangle_count() > k_many;
    const float all = width(scene.bounds());
    std::vector<Box> boxes;
    std::vector<size_t> counts;
    for (const Mesh& mesh : scene.meshes) {
      boxes.push_back(mesh.bounds());
      size_t count = 0;
      for (const MeshPart& part : mesh.parts) count += part.triangle_count();
      counts.push_back(count);
    }
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      const auto mesh = static_cast<size_t>(scene.objects[i].mesh);
      if (boxes[mesh].empty() || counts[mesh] == 0) continue;
      const Box box = transformed(scene.objects[i].world_from_object, boxes[mesh]);
      const double weight = std::sqrt(static_cast<double>(counts[mesh]));
      if (many && (k_wider * width(box) < all || counts[mesh] > k_most)) {
        list.push_back({box, i, pieces++, is_flat(box), weight});
      } else {
        take_apart(i, weight / static_cast<double>(counts[mesh]));
      }
    }
  }

  std::vector<Item> list;
  size_t pieces = 0;

 private:
  void take_apart(size_t object, double weight) {
    const Object& placed = scene_.objects[object];
    const Triangles triangles(scene_.meshes[static_cast<size_t>(placed.mesh)], placed.world_from_object);
    const std::vector<uint32_t>& index = triangles.indices;
    Sets joined(triangles.positions.size()), sheets(triangles.positions.size());
    std::vector<bool> level(index.size() / 3), taken(index.size() / 3);
    std::vector<float> widths;
    for (size_t i = 0; i + 2 < index.size(); i += 3) {
      level[i / 3] = triangles.level(i);
      if (level[i / 3]) widths.push_back(width(triangles.box(i)));
      for (const size_t k : {1u, 2u}) joined.join(index[i], index[i + k]);
    }
    // A vertex that strayed from a surface does not make all of it as wide.
    const auto middle = widths.begin() + static_cast<ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    const float widest = widths.empty() ? 0.0f : k_farther * *middle;
    for (size_t i = 0; i + 2 < index.size(); i += 3) {
      if (!level[i / 3]) continue;
      if (width(triangles.box(i)) > widest) {
        list.push_back({triangles.box(i), object, pieces + joined.find(index[i]), is_flat(triangles.box(i)), weight});
        level[i / 3] = false, taken[i / 3] = true;
      } else {
        for (const size_t k : {1u, 2u}) sheets.join(index[i], index[i + k]);
      }
    }
    std::vector<size_t> item_of(triangles.positions.size(), SIZE_MAX);
    for (size_t i = 0; i + 2 < index.size(); i += 3) {
      if (taken[i / 3]) continue;
      const size_t piece = pieces + joined.find(index[i]);
      if (!level[i / 3]) {
        list.push_back({triangles.box(i), object, piece, false, weight});
        continue;
      }
      size_t& item = item_of[sheets.find(index[i])];
      if (item == SIZE_MAX) item = list.size(), list.push_back({{}, object, piece, false, 0.0});
      list[item].box.add(triangles.box(i));
      list[item].weight += weight;
    }
    for (const size_t item : item_of) {
      if (item != SIZE_MAX) list[item].sheet = is_flat(list[item].box);
    }
    pieces += triangles.positions.size();
  }

  const Scene& scene_;
};

float reach(const Box& box, const vec3& from) {
  return glm::length(glm::max(glm::abs(box.min - from), glm::abs(box.max - from)));
}

// The weighted median of the pieces' middles. Of two halves far from each other, that at the origin.
vec3 middle_of(const std::vector<Item>& items) {
  float farthest = 0.0f;
  for (const Item& item : items) farthest = std::max(farthest, glm::length(item.box.centre()));
  std::vector<double> weights;
  for (const Item& item : items)
    weights.push_back(item.weight *
                      (1.1 - 0.1 * static_cast<double>(glm::length(item.box.centre()) / std::max(farthest, 1e-30f))));
  const double half = 0.5 * std::accumulate(weights.begin(), weights.end(), 0.0);
  vec3 middle(0.0f);
  std::vector<size_t> order(items.size());
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = [&](size_t i) { return items[i].box.centre()[axis]; };
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return place(a) < place(b); });
    double passed = 0.0;
    for (const size_t i : order) {
      middle[axis] = place(i);
      if ((passed += weights[i]) >= half) break;
    }
  }
  return middle;
}

// Leaves out the outermost pieces, half of the scene at most, where a gap many times as wide as all that is nearer parts them
// from the rest.
void leave_out_strays(std::vector<Item>& items, Subject& subject) {
  if (items.empty()) return;
  subject.middle = middle_of(items);
  const vec3 middle = subject.middle;
  std::vector<std::pair<float, size_t>> order;
  double left = 0.0, all = 0.0;
  float ground = std::numeric_limits<float>::max();
  for (size_t i = 0; i < items.size(); ++i) {
    all += items[i].weight;
    const Box& box = items[i].box;
    // The ground around the rest is no stray, however wide.
    const vec3 gap = glm::max(glm::max(box.min - middle, middle - box.max), vec3(0.0f));
    const bool sliver = std::min(box.extent().x, box.extent().z) * k_farther < width(box);
    const bool around = items[i].sheet && !sliver && gap.x == 0.0f && gap.z == 0.0f && gap.y <= width(box);
    if (!around) order.emplace_back(reach(box, middle), i);
    if (around) ground = std::min(ground, reach(box, middle));
  }
  std::sort(order.begin(), order.end());
  for (const auto& [distance, i] : order) left += items[i].weight;
  const double outermost = 0.5 * all + 1e-9 * all;
  size_t kept = order.size();
  float inner = order.empty() || order[0].first > ground ? ground : 0.0f;
  for (size_t k = 0; k < order.size(); ++k) {
    const float gap = left <= k_little * all ? k_far : k_farther;
    if (inner > 0.0f && order[k].first > gap * inner && left <= outermost) {
      kept = k;
      break;
    }
    inner = order[k].first;
    left -= items[order[k].second].weight;
  }
  for (size_t k = kept; k < order.size(); ++k) {
    items[order[k].second].counts = false;
    subject.stray[items[order[k].second].object] = true;
    subject.cropped = true;
  }
  subject.usual_m = inner;
}

// Sheets at one height, of about one size: the tiles of a ground.
struct Sheets {
  Box box;
  float height_m = 0.0f, width_m = 0.0f;  // of the last one added
  std::vector<size_t> items;
};

std::vector<Sheets> sheets_of(const std::vector<Item>& items) {
  std::vector<size_t> order;
  for (size_t i = 0; i < items.size(); ++i) {
    if (items[i].counts && items[i].sheet) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return width(items[a].box) > width(items[b].box); });
  std::vector<Sheets> groups;
  constexpr size_t k_groups = 24;
  constexpr float k_same_size = 4.0f, k_same_height = 0.01f;
  for (const size_t i : order) {
    const Box& box = items[i].box;
    const float w = width(box);
    const auto fits = [&](const Sheets& group) {
      return k_same_size * w >= group.width_m && box.min.y <= group.box.max.y + k_same_height * w &&
             box.max.y >= group.box.min.y - k_same_height * w;
    };
    auto group = std::find_if(groups.begin(), groups.end(), fits);
    if (group == groups.end() && groups.size() == k_groups) continue;
    if (group == groups.end()) group = groups.insert(groups.end(), Sheets());
    group->box.add(box);
    group->width_m = w;
    group->items.push_back(i);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Sheets& a, const Sheets& b) { return width(a.box) > width(b.box); });
  return groups;
}

// Leaves out one wide sheet after the other while what stands on them is far smaller.
class Ground {
 public:
  Ground(std::vector<Item>& items, size_t pieces, Subject& subject)
      : items_(items), top_of_piece_(pieces, std::numeric_limits<float>::lowest()), subject_(subject) {
    const Box all = rest();
    subject_.box = all;
    for (const Sheets& sheets : sheets_of(items_)) {
      // A ceiling, or the top of a table, is no ground.
      if (!ground_.empty() && sheets.box.min.y > ground_.max.y + k_flat * sheets.width_m) continue;
      const std::vector<float> tops = top_of_piece_;
      for (const size_t i : sheets.items) {
        items_[i].counts = false;
        float& top = top_of_piece_[items_[i].piece];
        top = std::max(top, items_[i].box.max.y);
      }
      const Box above = rest();
      if (above.empty() || above.centre().y < sheets.box.min.y) {
        for (const size_t i : sheets.items) items_[i].counts = true;
        top_of_piece_ = tops;
        continue;
      }
      ground_.add(sheets.box);

      if (const Box seen = with_shadow(above, all); width(subject_.box) >= k_wider * width(seen)) {
        subject_.box = seen;
        subject_.cropped = true;
      }
    }
  }

 private:
  // What counts, but for the sides and the underside of what was left out: they do not rise above it.
  Box rest() const {
    Box box;
    for (const Item& item : items_) {
      const float top = top_of_piece_[item.piece], own = item.box.max.y;
      if (item.counts && (own > top || (item.sheet && own == top))) box.add(item.box);
    }
    return box;
  }
  // With as much of the ground around it as it is high: there its shadow lies.
  Box with_shadow(Box box, const Box& all) const {
    const float level = std::min(ground_.max.y, box.min.y), height = box.max.y - level;
    box.min = glm::max(vec3(box.min.x - height, level, box.min.z - height), all.min);
    box.max = glm::min(vec3(box.max.x + height, box.max.y, box.max.z + height), all.max);
    return box;
  }

  std::vector<Item>& items_;
  std::vector<float> top_of_piece_;
  Subject& subject_;
  Box ground_;
};

}  // namespace

Subject find_subject(const Scene& scene) {
  Subject subject;
  subject.stray.resize(scene.objects.size(), false);
  Items items(scene);
  leave_out_strays(items.list, subject);
  Ground(items.list, items.pieces, subject);
  return subject;
}

Box shadowed_bounds(const Scene& scene) {
  const bool all_cast = std::all_of(scene.objects.begin(), scene.objects.end(),
                                    [&](const Object& object) { return object_casts(scene, object); });
  if (all_cast) return scene.bounds();  // also the quick way
  const Subject subject = find_subject(scene);
  Box box;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (subject.stray[i] && !object_casts(scene, object)) continue;
    const Box placed = transformed(object.world_from_object, scene.meshes[static_cast<size_t>(object.mesh)].bounds());
    if (!placed.empty()) box.add(placed);
  }
  return box;
}

}  // namespace gnomon
