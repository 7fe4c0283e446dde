// Stone: paving, colonnade, the wall with the gate, stairs, tower, garden wall.
#include <array>
#include <cmath>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/scenes/courtyard/courtyard_parts.h"

namespace gnomon {
namespace {

// Front and back of one upright strip of wall, and its top; the lower edge may slope.
void add_strip(MeshPart& part, const Arcade& arcade, float x0, float x1, float low0, float low1, float high, bool capped,
               float uv_scale) {
  const float back = -arcade.thickness;
  const auto corner = [&](float x, float y, bool front) {
    return add_vertex(part, {x, y, front ? 0.0f : back}, {0, 0, front ? 1 : -1}, uv_scale * vec2(front ? x : -x, -y));
  };
  for (const bool front : {true, false}) {
    const float left = front ? x0 : x1, right = front ? x1 : x0, low_left = front ? low0 : low1,
                low_right = front ? low1 : low0;
    const uint32_t a = corner(left, low_left, front), b = corner(right, low_right, front), c = corner(right, high, front),
                   d = corner(left, high, front);
    add_triangle(part, a, b, c);
    add_triangle(part, a, c, d);
  }
  if (capped)
    add_quad(part, {x0, high, 0}, {x1, high, 0}, {x1, high, back}, {x0, high, back}, uv_scale * vec2(x0, 0),
             uv_scale * vec2(x1, arcade.thickness));
}

// Upright face across the wall's thickness, seen from -X (or from +X).
void add_jamb(MeshPart& part, const Arcade& arcade, float x, float low, float high, bool from_left, float uv_scale) {
  if (low == high) return;
  const float z0 = from_left ? -arcade.thickness : 0.0f, z1 = from_left ? 0.0f : -arcade.thickness;
  add_quad(part, {x, low, z0}, {x, low, z1}, {x, high, z1}, {x, high, z0}, uv_scale * vec2(0, -high),
           uv_scale * vec2(arcade.thickness, -low));
}

// One opening from its left jamb at x: wall above the arch and the arch's underside.
void add_arch(MeshPart& part, const Arcade& arcade, float x, float uv_scale) {
  const float radius = 0.5f * arcade.opening, centre = x + radius;
  std::array<vec2, 65> rim;
  for (int i = 0; i <= arcade.segments; ++i) {
    const glm::dvec2 turn = unit_circle(radians_of(180.0 * (arcade.segments - i) / arcade.segments));
    rim[static_cast<size_t>(i)] = {centre + radius * static_cast<float>(turn.x),
                                   arcade.springing + radius * static_cast<float>(turn.y)};
  }
  // Exactly where the supports end.
  rim[0] = {x, arcade.springing}, rim[static_cast<size_t>(arcade.segments)] = {x + arcade.opening, arcade.springing};
  for (size_t i = 0; i < static_cast<size_t>(arcade.segments); ++i) {
    const vec2 a = rim[i], b = rim[i + 1];
    add_strip(part, arcade, a.x, b.x, a.y, b.y, arcade.top, true, uv_scale);
    const auto at = [&](const vec2& p, float z, float along) {
      const vec2 inward = glm::normalize(vec2(centre, arcade.springing) - p);
      return add_vertex(part, {p.x, p.y, z}, vec3(inward, 0), uv_scale * vec2(along, z));
    };
    const float step = 0.5f * k_pi * arcade.opening / static_cast<float>(arcade.segments), u = step * static_cast<float>(i);
    const uint32_t a0 = at(a, 0, u), b0 = at(b, 0, u + step), b1 = at(b, -arcade.thickness, u + step),
                   a1 = at(a, -arcade.thickness, u);
    add_triangle(part, a0, a1, b1);
    add_triangle(part, a0, b1, b0);
  }
}

// Corrugated sheet of tiles: both slopes of a ridge along X of that length.
void add_tiles(MeshPart& part, float length, float half_depth, float rise, int tiles) {
  for (const double side : {1.0, -1.0}) {
    const SurfaceGrid grid{tiles * 4, 1, false, false, {static_cast<float>(tiles) * 0.25f, 0.5f}};
    add_surface(part, grid, [&](double u, double v) {
      const double x = side > 0 ? u * length : (1.0 - u) * length;
      const double wave = 0.045 * sine(6.283185307179586 * x / length * tiles);
      return glm::dvec3(x, rise * v + wave, side * half_depth * (1.0 - v));
    });
  }
}

}  // namespace

void add_arcade(MeshPart& part, const Arcade& arcade, float uv_scale) {
  const float half_pier = 0.5f * (arcade.span - arcade.opening);
  for (int support = 0; support <= arcade.spans; ++support) {
    const float middle = static_cast<float>(support) * arcade.span, left = middle - half_pier, right = left + 2.0f * half_pier;
    // In two pieces, so that every edge meets an edge of the arch or of the jamb.
    if (arcade.bottom < arcade.springing)
      add_strip(part, arcade, left, right, arcade.bottom, arcade.bottom, arcade.springing, false, uv_scale);
    add_strip(part, arcade, left, right, arcade.springing, arcade.springing, arcade.top, true, uv_scale);
    add_quad(part, {left, arcade.bottom, -arcade.thickness}, {right, arcade.bottom, -arcade.thickness},
             {right, arcade.bottom, 0}, {left, arcade.bottom, 0}, uv_scale * vec2(left, 0),
             uv_scale * vec2(right, arcade.thickness));
    add_jamb(part, arcade, left, arcade.bottom, arcade.springing, true, uv_scale);
    add_jamb(part, arcade, right, arcade.bottom, arcade.springing, false, uv_scale);
    if (support == 0) add_jamb(part, arcade, left, arcade.springing, arcade.top, true, uv_scale);
    if (support == arcade.spans) add_jamb(part, arcade, right, arcade.springing, arcade.top, false, uv_scale);
    if (support < arcade.spans) add_arch(part, arcade, right, uv_scale);
  }
}

double courtyard_ground(double x, double z) {
  return 0.11 * (fractal({0.45 * x, 0.0, 0.45 * z}, 2, 31) - 0.5) + 0.03 * (noise({1.7 * x, 5.0, 1.7 * z}, 37) - 0.5);
}

void add_paving(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart part = part_of(materials.paving);
  constexpr double k_side = 28.0;
  add_surface(part, {36, 36, false, false, vec2(static_cast<float>(k_side / 2.2))}, [](double u, double v) {
    const double x = k_side * (u - 0.5) + 2.0, z = k_side * (0.5 - v);
    return glm::dvec3(x, courtyard_ground(x, z), z);
  });
  add_object(scene, "paving", add_mesh(scene, "paving", {part}));
}

// Six columns along z = -5 that carry five arches under a small tiled roof.
void add_colonnade(Scene& scene, const CourtyardMaterials& materials) {
  constexpr float k_west = -6.6f, k_north = -5.0f, k_span = 2.2f, k_springing = 2.75f;
  constexpr int k_spans = 5;
  MeshPart column = part_of(materials.limestone);
  // A Tuscan column: plinth and abacus are boxes, between them a torus, a shaft with entasis, a necking and an echinus.
  const std::vector<vec2> profile = {{0.24f, 0.12f},  {0.285f, 0.16f}, {0.285f, 0.20f}, {0.24f, 0.24f},  {0.225f, 0.25f},
                                     {0.205f, 0.32f}, {0.205f, 0.95f}, {0.19f, 1.70f},  {0.165f, 2.36f}, {0.195f, 2.38f},
                                     {0.195f, 2.42f}, {0.17f, 2.44f},  {0.17f, 2.52f},  {0.25f, 2.62f}};
  add_lathe(column, profile, 16, {2.0f, 3.0f});
  add_box(column, {-0.30f, -0.25f, -0.30f}, {0.30f, 0.12f, 0.30f}, 0.7f);
  add_box(column, {-0.29f, 2.62f, -0.29f}, {0.29f, k_springing, 0.29f}, 0.7f);
  const int column_mesh = add_mesh(scene, "column", {column});
  for (int i = 0; i <= k_spans; ++i) {
    add_object(scene, "column_" + std::to_string(i), column_mesh,
               translation({k_west + k_span * static_cast<float>(i), 0, k_north}));
  }
  Arcade arcade;
  arcade.spans = k_spans, arcade.span = k_span, arcade.opening = 1.72f, arcade.bottom = arcade.springing = k_springing;
  arcade.top = 4.15f, arcade.thickness = 0.44f;
  MeshPart wall = part_of(materials.plaster), roof = part_of(materials.terracotta);
  add_arcade(wall, arcade, 0.45f);
  MeshPart tiles;
  add_tiles(tiles, k_span * k_spans + 0.8f, 0.46f, 0.26f, 36);
  append(roof, tiles, translation({-0.4f, arcade.top + 0.03f, -0.22f}));
  add_object(scene, "arcade", add_mesh(scene, "arcade", {wall, roof}), translation({k_west, 0, k_north + 0.22f}));
}

// Along x = 7, with a gate at the head of the stairs.
void add_gate_wall(Scene& scene, const CourtyardMaterials& materials) {
  Arcade wall;
  wall.spans = 1, wall.opening = 1.5f, wall.span = 8.25f, wall.bottom = -0.3f, wall.springing = 2.45f, wall.top = 4.7f,
  wall.thickness = 0.5f;
  wall.segments = 16;
  MeshPart plaster = part_of(materials.plaster), trim = part_of(materials.limestone);
  add_arcade(plaster, wall, 0.4f);
  Arcade frame = wall;  // a stone frame around the opening, proud of the plaster on all sides
  frame.opening = 1.44f, frame.span = 1.98f, frame.top = 3.62f, frame.thickness = 0.66f;
  MeshPart arch;
  add_arcade(arch, frame, 0.8f);
  append(trim, arch, translation({0.5f * (wall.span - frame.span), 0, 0.08f}));
  add_box(trim, {-3.45f, 4.7f, -0.62f}, {11.7f, 4.86f, 0.12f}, 0.7f);  // coping
  add_box(trim, {-3.38f, -0.3f, 0.0f}, {2.87f, 0.35f, 0.06f}, 0.7f);   // skirting on both sides of the stairs
  add_box(trim, {5.38f, -0.3f, 0.0f}, {11.6f, 0.35f, 0.06f}, 0.7f);
  // x of the wall runs along +Z, its front looks to -X.
  const mat4 turn = mat4(vec4(0, 0, 1, 0), vec4(0, 1, 0, 0), vec4(-1, 0, 0, 0), vec4(7, 0, -3.2f, 1));
  add_object(scene, "gate_wall", add_mesh(scene, "gate_wall", {plaster, trim}), turn);
  MeshPart door = part_of(materials.wood), fittings = part_of(materials.iron);
  for (int i = 0; i < 5; ++i) {
    const float x = 0.142f * static_cast<float>(i);
    add_box(door, {x, 0, -0.02f}, {x + 0.138f, 2.35f, 0.03f}, 1.1f);
  }
  for (const float y : {0.35f, 1.95f}) add_box(fittings, {0, y, 0.03f}, {0.66f, y + 0.06f, 0.042f}, 1.0f);
  const mat4 open = translation({7.1f, 0.80f, 0.20f}) * rotation({0, 1, 0}, radians_of(110.0));
  add_object(scene, "door", add_mesh(scene, "door", {door, fittings}), open);
}

// Five steps up to the gate, a railing of real bars on the southern side.
void add_stairs(Scene& scene, const CourtyardMaterials& materials) {
  constexpr float k_rise = 0.16f, k_tread = 0.34f, k_north = -0.55f, k_south = 2.4f, k_landing = 6.25f;
  constexpr int k_steps = 5;
  MeshPart stone = part_of(materials.masonry), treads = part_of(materials.limestone), iron = part_of(materials.iron);
  for (int i = 0; i < k_steps; ++i) {
    const float x = k_landing - k_tread * static_cast<float>(k_steps - 1 - i), y = k_rise * static_cast<float>(i + 1);
    const float end = i == k_steps - 1 ? 7.6f : x + k_tread;
    add_box(stone, {x, -0.3f, k_north}, {end, y - 0.05f, k_south}, 0.5f);
    add_box(treads, {x - 0.03f, y - 0.05f, k_north - 0.03f}, {end, y, k_south + 0.03f}, 0.7f);
  }
  std::vector<vec3> rail;
  for (int i = -1; i < k_steps; ++i) {
    const float x = k_landing - k_tread * static_cast<float>(k_steps - 1 - i) + 0.16f, y = k_rise * static_cast<float>(i + 1);
    const float foot = i < 0 ? -0.1f : y - 0.02f;
    add_box(iron, {x - 0.011f, foot, k_south - 0.111f}, {x + 0.011f, y + 0.92f, k_south - 0.089f}, 1.0f);
    rail.push_back({x, y + 0.92f, k_south - 0.1f});
  }
  rail.push_back({6.98f, rail.back().y, k_south - 0.1f});
  rail.insert(rail.begin(), rail.front() + vec3(-0.22f, -0.06f, 0.0f));
  add_tube(iron, rail, std::vector<float>(rail.size(), 0.022f), 8, 2.0f);
  add_object(scene, "stairs", add_mesh(scene, "stairs", {stone, treads, iron}));
}

// Slender bell tower in the north-west, whose shadow crosses the court up to the gate wall.
void add_tower(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart stone = part_of(materials.masonry), trim = part_of(materials.limestone), roof = part_of(materials.terracotta),
           iron = part_of(materials.iron);
  add_box(stone, {-0.8f, -0.3f, -0.8f}, {0.8f, 6.6f, 0.8f}, 0.45f);
  add_box(trim, {-0.92f, 6.6f, -0.92f}, {0.92f, 6.8f, 0.92f}, 0.7f);
  for (const float x : {-0.8f, 0.48f}) {  // an open belfry on four piers
    for (const float z : {-0.8f, 0.48f}) add_box(stone, {x, 6.8f, z}, {x + 0.32f, 8.3f, z + 0.32f}, 0.45f);
  }
  add_box(trim, {-0.92f, 8.3f, -0.92f}, {0.92f, 8.5f, 0.92f}, 0.7f);
  const std::vector<vec2> pyramid = {{0.0f, 8.5f}, {1.25f, 8.5f}, {0.0f, 9.6f}};
  MeshPart cap;
  add_lathe(cap, pyramid, 4, {2.0f, 1.0f});
  append(roof, cap, rotation({0, 1, 0}, radians_of(45.0)));
  const std::vector<vec2> bell = {{0.0f, 7.25f}, {0.30f, 7.22f}, {0.33f, 7.25f}, {0.24f, 7.45f}, {0.18f, 7.75f}, {0.0f, 7.85f}};
  add_lathe(iron, bell, 14, {1.0f, 1.0f});
  add_box(iron, {-0.02f, 7.8f, -0.02f}, {0.02f, 8.3f, 0.02f}, 1.0f);
  add_box(iron, {-0.02f, 9.5f, -0.02f}, {0.02f, 10.3f, 0.02f}, 1.0f);
  add_box(iron, {-0.2f, 9.95f, -0.018f}, {0.2f, 9.99f, 0.018f}, 1.0f);
  add_object(scene, "tower", add_mesh(scene, "tower", {stone, trim, roof, iron}), translation({-4.3f, 0, -11.4f}));
}

// Closes the view to the north behind the colonnade.
void add_garden_wall(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart stone = part_of(materials.masonry), coping = part_of(materials.limestone);
  add_box(stone, {-12.0f, -0.3f, -8.8f}, {16.0f, 1.75f, -8.4f}, 0.45f);
  add_box(coping, {-12.0f, 1.75f, -8.88f}, {16.0f, 1.87f, -8.32f}, 0.7f);
  add_object(scene, "garden_wall", add_mesh(scene, "garden_wall", {stone, coping}));
}

}  // namespace gnomon
