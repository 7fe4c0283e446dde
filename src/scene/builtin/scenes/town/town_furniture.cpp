// Things that stand in the town's streets, and its tall ones.
#include <algorithm>
#include <cmath>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/builtin/scenes/town/town_parts.h"

namespace gnomon {
namespace {

int scaled(int count, double detail, int least) { return std::max(least, static_cast<int>(count * std::sqrt(detail) + 0.5)); }

// A square bar between two points.
void add_bar(MeshPart& part, const vec3& from, const vec3& to, float half) {
  const vec3 along = glm::normalize(to - from);
  vec3 a, b;
  orthonormal_basis(along, a, b);
  MeshPart box;
  add_box(box, {-half, -half, 0}, {half, half, glm::length(to - from)}, 0.5f);
  append(part, box, mat4(vec4(a, 0), vec4(b, 0), vec4(along, 0), vec4(from, 1)));
}

// Four chords with diagonals, square in section, from the origin along `along`; `side` and `other` span the section.
void add_lattice(MeshPart& part, const vec3& from, const vec3& along, const vec3& side, const vec3& other, float half,
                 int cells, float cell) {
  const auto corner = [&](int i, int k) {
    const float x = k == 0 || k == 3 ? -half : half, y = k < 2 ? -half : half;
    return from + along * (cell * static_cast<float>(i)) + side * x + other * y;
  };
  for (int k = 0; k < 4; ++k) {
    add_bar(part, corner(0, k), corner(cells, k), 0.07f);
    for (int i = 0; i < cells; ++i) {
      const int next = (k + 1) % 4;
      i % 2 == 0 ? add_bar(part, corner(i, k), corner(i + 1, next), 0.04f)
                 : add_bar(part, corner(i, next), corner(i + 1, k), 0.04f);
      add_bar(part, corner(i + 1, k), corner(i + 1, next), 0.035f);
    }
  }
}

}  // namespace

std::vector<MeshPart> make_lamp_post(const TownMaterials& m, double detail) {
  MeshPart iron = part_of(m.iron), glass = part_of(m.lamp);
  const int round = scaled(10, detail, 5);
  const std::vector<vec2> pole = {{0.17f, 0.0f},  {0.17f, 0.25f}, {0.11f, 0.32f}, {0.10f, 0.9f}, {0.06f, 1.0f},
                                  {0.045f, 4.3f}, {0.08f, 4.35f}, {0.08f, 4.42f}, {0.0f, 4.45f}};
  add_lathe(iron, pole, round, {1, 1});
  for (const float side : {-1.0f, 1.0f}) {
    add_tube(iron, std::vector<vec3>{{0, 3.9f, 0}, {side * 0.35f, 4.25f, 0}, {side * 0.62f, 4.2f, 0}, {side * 0.7f, 4.02f, 0}},
             std::vector<float>{0.03f, 0.028f, 0.025f, 0.02f}, std::max(4, round - 4), 1.0f);
    MeshPart head, cap;
    const std::vector<vec2> lantern = {{0.0f, 3.5f}, {0.10f, 3.52f}, {0.17f, 3.88f}, {0.0f, 3.9f}};
    const std::vector<vec2> roof = {{0.0f, 3.88f}, {0.22f, 3.88f}, {0.06f, 4.04f}, {0.0f, 4.1f}};
    add_lathe(head, lantern, round, {1, 1});
    add_lathe(cap, roof, round, {1, 1});
    append(glass, head, translation({side * 0.7f, 0, 0}));
    append(iron, cap, translation({side * 0.7f, 0, 0}));
  }
  return {iron, glass};
}

std::vector<MeshPart> make_bench(const TownMaterials& m) {
  MeshPart wood = part_of(m.wood), iron = part_of(m.iron);
  for (int i = 0; i < 5; ++i) {
    const float z = -0.22f + 0.1f * static_cast<float>(i);
    add_box(wood, {-0.85f, 0.43f, z}, {0.85f, 0.46f, z + 0.075f}, 1.0f);
  }
  for (int i = 0; i < 3; ++i) {
    const float y = 0.56f + 0.14f * static_cast<float>(i), z = -0.27f - 0.03f * static_cast<float>(i);
    add_box(wood, {-0.85f, y, z}, {0.85f, y + 0.1f, z + 0.03f}, 1.0f);
  }
  for (const float x : {-0.75f, 0.69f}) {
    add_box(iron, {x, 0.0f, -0.24f}, {x + 0.06f, 0.43f, -0.18f}, 1.0f);
    add_box(iron, {x, 0.0f, 0.18f}, {x + 0.06f, 0.43f, 0.24f}, 1.0f);
    add_box(iron, {x, 0.40f, -0.24f}, {x + 0.06f, 0.43f, 0.26f}, 1.0f);
    add_bar(iron, {x + 0.03f, 0.43f, -0.24f}, {x + 0.03f, 0.98f, -0.36f}, 0.02f);
  }
  return {wood, iron};
}

std::vector<MeshPart> make_car(const TownMaterials& m, int paint, bool van, double detail) {
  MeshPart body = part_of(paint), glass = part_of(m.glass), rubber = part_of(m.asphalt);
  const float roof = van ? 1.95f : 1.45f, tail = van ? -2.1f : -1.35f, nose = van ? 1.35f : 0.55f;
  add_prism(body,
            {{-2.2f, 0.28f}, {2.15f, 0.28f}, {2.25f, 0.5f}, {2.15f, 0.78f}, {1.2f, 0.92f}, {-2.15f, 0.95f}, {-2.28f, 0.6f}},
            -0.86f, 0.86f, 0.5f);
  add_prism(body, {{tail - 0.45f, 0.9f}, {nose + 0.75f, 0.88f}, {nose, roof}, {tail, roof}}, -0.74f, 0.74f, 0.5f);
  // Panes stand a little proud of the cabin.
  add_prism(glass, {{tail - 0.25f, 0.98f}, {nose + 0.45f, 0.98f}, {nose - 0.08f, roof - 0.1f}, {tail + 0.05f, roof - 0.1f}},
            -0.755f, 0.755f, 0.5f);
  const float slant = (roof - 0.9f) / 0.75f;
  add_quad(glass, {nose + 0.66f, 0.98f, 0.64f}, {nose + 0.66f, 0.98f, -0.64f},
           {nose + 0.66f - (roof - 1.08f) / slant, roof - 0.1f, -0.58f},
           {nose + 0.66f - (roof - 1.08f) / slant, roof - 0.1f, 0.58f}, {0, 0}, {1, 1});
  const std::vector<vec2> wheel = {{0.0f, -0.11f}, {0.20f, -0.11f}, {0.33f, -0.10f},
                                   {0.33f, 0.10f}, {0.20f, 0.11f},  {0.0f, 0.10f}};
  const int round = scaled(14, detail, 8);
  for (const float x : {-1.4f, 1.4f}) {
    for (const float z : {-0.8f, 0.8f}) {
      MeshPart disc;
      add_lathe(disc, wheel, round, {1, 1});
      append(rubber, disc, translation({x, 0.33f, z}) * rotation({1, 0, 0}, radians_of(z > 0 ? 90.0 : -90.0)));
    }
  }
  for (const float z : {-0.92f, 0.82f})
    add_box(body, {nose + 0.35f, 1.0f, z}, {nose + 0.48f, 1.12f, z + 0.1f}, 1.0f);  // mirrors
  return {body, glass, rubber};
}

std::vector<MeshPart> make_picket_fence(const TownMaterials& m, float length, double detail) {
  MeshPart wood = part_of(m.wood);
  const int pickets = std::max(6, static_cast<int>(length / 0.24 * std::min(1.0, std::sqrt(detail))));
  for (const float y : {0.3f, 0.85f}) add_box(wood, {0, y, -0.02f}, {length, y + 0.07f, 0.02f}, 1.0f);
  const float step = length / static_cast<float>(pickets);
  for (int i = 0; i < pickets; ++i) {
    const float x = step * (static_cast<float>(i) + 0.15f), wide = std::min(0.1f, 0.7f * step);
    add_prism(wood, {{x, 0.08f}, {x + wide, 0.08f}, {x + wide, 1.1f}, {x + 0.5f * wide, 1.2f}, {x, 1.1f}}, 0.02f, 0.045f, 1.0f);
  }
  return {wood};
}

std::vector<MeshPart> make_planter(const TownMaterials& m, double detail) {
  MeshPart stone = part_of(m.stone);
  add_box(stone, {-0.55f, 0.0f, -0.55f}, {0.55f, 0.5f, 0.55f}, 0.8f);
  std::vector<MeshPart> bush = make_bush(m.shrub, 0.45f, 0.7f, std::max(6, static_cast<int>(60 * detail)), 0.5f, 81);
  MeshPart leaves = part_of(m.shrub);
  append(leaves, bush.front(), translation({0, 0.5f, 0}));
  return {stone, leaves};
}

std::vector<MeshPart> make_tower(const TownMaterials& m, double detail) {
  MeshPart wall = part_of(m.masonry), trim = part_of(m.stone), roof = part_of(m.roof), iron = part_of(m.iron),
           glass = part_of(m.glass);
  add_box(wall, {-4.5f, -0.5f, -4.5f}, {4.5f, 6.0f, 4.5f}, 0.4f);
  add_box(wall, {-3.8f, 6.0f, -3.8f}, {3.8f, 36.0f, 3.8f}, 0.4f);
  for (const float y : {6.0f, 16.0f, 26.0f, 36.0f}) add_box(trim, {-4.1f, y, -4.1f}, {4.1f, y + 0.4f, 4.1f}, 0.5f);
  for (const float x : {-3.5f, 2.2f}) {  // an open belfry on four piers
    for (const float z : {-3.5f, 2.2f}) add_box(wall, {x, 36.4f, z}, {x + 1.3f, 43.0f, z + 1.3f}, 0.4f);
  }
  for (const float s : {-3.0f, 2.85f}) {  // its railings
    for (int i = 0; i < 12; ++i) {
      const float t = -2.1f + 0.36f * static_cast<float>(i);
      add_box(iron, {t, 36.4f, s}, {t + 0.06f, 37.6f, s + 0.06f}, 1.0f);
      add_box(iron, {s, 36.4f, t}, {s + 0.06f, 37.6f, t + 0.06f}, 1.0f);
    }
    add_box(iron, {-2.2f, 37.55f, s - 0.02f}, {2.2f, 37.65f, s + 0.1f}, 1.0f);
    add_box(iron, {s - 0.02f, 37.55f, -2.2f}, {s + 0.1f, 37.65f, 2.2f}, 1.0f);
  }
  add_box(trim, {-4.1f, 43.0f, -4.1f}, {4.1f, 43.6f, 4.1f}, 0.5f);
  const std::vector<vec2> pyramid = {{0.0f, 43.6f}, {5.4f, 43.6f}, {0.35f, 54.0f}, {0.0f, 54.0f}};
  MeshPart cap;
  add_lathe(cap, pyramid, 4, {6.0f, 3.0f});
  append(roof, cap, rotation({0, 1, 0}, radians_of(45.0)));
  const int round = scaled(20, detail, 8);
  const std::vector<vec2> bell = {{0.0f, 39.2f}, {1.1f, 39.1f}, {1.2f, 39.2f}, {0.85f, 40.0f}, {0.6f, 41.2f}, {0.0f, 41.6f}};
  add_lathe(iron, bell, round, {1, 1});
  add_bar(iron, {0, 41.5f, 0}, {0, 43.0f, 0}, 0.06f);
  add_bar(iron, {0, 54.0f, 0}, {0, 58.0f, 0}, 0.06f);
  add_sphere(iron, {0, 55.0f, 0}, 0.35f, round, std::max(4, round / 2), {1, 1});
  for (int level = 0; level < 3; ++level) {
    const float y = 9.5f + 10.0f * static_cast<float>(level);
    for (const float s : {-3.82f, 3.74f}) {
      add_box(glass, {-0.7f, y, s}, {0.7f, y + 2.6f, s + 0.08f}, 1.0f);
      add_box(glass, {s, y, -0.7f}, {s + 0.08f, y + 2.6f, 0.7f}, 1.0f);
    }
  }
  return {wall, trim, roof, iron, glass};
}

std::vector<MeshPart> make_crane(const TownMaterials& m, double detail) {
  MeshPart paint = part_of(m.paint), stone = part_of(m.stone), iron = part_of(m.iron);
  const int cells = scaled(18, detail, 8);
  const float height = 36.0f, jib = 34.0f;
  add_lattice(paint, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0.7f, cells, height / static_cast<float>(cells));
  add_lattice(paint, {-0.7f, height, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.55f, cells, jib / static_cast<float>(cells));
  add_lattice(paint, {0.7f, height, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.55f, std::max(3, cells / 3),
              12.0f / static_cast<float>(std::max(3, cells / 3)));
  add_lattice(paint, {0, height, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0.4f, 3, 1.8f);
  add_box(stone, {-11.5f, height - 2.2f, -0.6f}, {-9.0f, height - 0.5f, 0.6f}, 0.5f);
  add_box(stone, {-2.5f, -0.3f, -2.5f}, {2.5f, 0.6f, 2.5f}, 0.5f);
  add_box(paint, {0.8f, height - 2.4f, -0.8f}, {2.3f, height - 0.5f, 0.8f}, 0.5f);
  for (const float x : {0.55f * jib, -10.0f}) add_bar(iron, {0, height + 5.4f, 0}, {x, height + 0.5f, 0}, 0.03f);
  add_bar(iron, {0.8f * jib, height - 14.0f, 0}, {0.8f * jib, height - 0.5f, 0}, 0.025f);
  add_box(stone, {0.8f * jib - 1.5f, height - 15.2f, -0.6f}, {0.8f * jib + 1.5f, height - 14.0f, 0.6f}, 0.5f);
  return {paint, stone, iron};
}

std::vector<MeshPart> make_water_tower(const TownMaterials& m, double detail) {
  MeshPart iron = part_of(m.iron), wood = part_of(m.wood);
  const std::vector<vec2> tank = {{0.0f, 15.0f}, {3.6f, 15.0f}, {3.6f, 20.0f}, {4.0f, 20.0f}, {0.3f, 22.4f}, {0.0f, 22.4f}};
  add_lathe(wood, tank, scaled(24, detail, 8), {10, 3});
  for (const float x : {-1.0f, 1.0f}) {
    for (const float z : {-1.0f, 1.0f}) add_bar(iron, {3.4f * x, -0.3f, 3.4f * z}, {2.3f * x, 15.0f, 2.3f * z}, 0.14f);
  }
  for (int level = 0; level < 3; ++level) {
    const float y0 = 0.3f + 4.8f * static_cast<float>(level), y1 = y0 + 4.8f;
    const float r0 = 3.4f - 1.1f * y0 / 15.0f, r1 = 3.4f - 1.1f * y1 / 15.0f;
    for (int k = 0; k < 4; ++k) {
      const vec2 a = k == 0 ? vec2(-1, -1) : k == 1 ? vec2(1, -1) : k == 2 ? vec2(1, 1) : vec2(-1, 1), b(-a.y, a.x);
      add_bar(iron, {r0 * a.x, y0, r0 * a.y}, {r1 * b.x, y1, r1 * b.y}, 0.04f);
      add_bar(iron, {r0 * b.x, y0, r0 * b.y}, {r1 * a.x, y1, r1 * a.y}, 0.04f);
      add_bar(iron, {r1 * a.x, y1, r1 * a.y}, {r1 * b.x, y1, r1 * b.y}, 0.06f);
    }
  }
  return {iron, wood};
}

}  // namespace gnomon
