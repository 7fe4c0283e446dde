// lamps: a closed room at night. A pendant lamp over a table, a spot lamp behind a grating and the beam of a projector; no sun.
// Shadows start at the lamps' feet and cross in every direction.
#include <array>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/path.h"

namespace gnomon {
namespace {

constexpr vec3 k_half(4.5f, 1.7f, 3.5f);  // of the room, whose floor is y = 0 [m]
constexpr vec3 k_pendant(0.4f, 1.92f, 0.1f), k_spot(-4.05f, 2.75f, -2.95f), k_projector(4.2f, 2.4f, 0.55f);

struct Materials {
  int plaster, floor, wood, dark_wood, stone, iron, grille, brass, bulb, leaves, pot, cloth;
  std::array<int, 4> books;
};

Materials add_materials(Scene& scene) {
  Materials m;
  const Material wood = textured_material(scene, "wood", wood_texture(256)),
                 stone = textured_material(scene, "limestone", limestone_texture(256));
  m.plaster = add_material(scene, plain_material("wall", {0.66f, 0.64f, 0.60f}));
  m.floor = add_material(scene, shiny(tinted(wood, "floor", {0.80f, 0.62f, 0.45f}), 0.10f, 30.0f));
  m.wood = add_material(scene, tinted(wood, "oak", {0.95f, 0.85f, 0.70f}));
  m.dark_wood = add_material(scene, tinted(wood, "walnut", {0.45f, 0.30f, 0.22f}));
  m.stone = add_material(scene, tinted(stone, "marble", {0.95f, 0.95f, 0.95f}));
  m.iron = add_material(scene, shiny(plain_material("iron", {0.04f, 0.04f, 0.045f}), 0.3f, 40.0f));
  m.grille = add_material(scene, cut_out_material(scene, "grille", iron_panel_texture(256), Wrap::repeat));
  Material brass = shiny(plain_material("brass", {0.75f, 0.55f, 0.22f}), 0.5f, 60.0f);
  brass.double_sided = true;  // shades are sheets
  m.brass = add_material(scene, brass);
  Material bulb = plain_material("bulb", {0.9f, 0.9f, 0.9f});
  bulb.emissive = vec3(4.0f, 3.4f, 2.6f);
  m.bulb = add_material(scene, bulb);
  m.leaves = add_material(
      scene, cut_out_material(scene, "leaves",
                              twig_texture(128, {5, 0.45f, 0.20f, 0.9f, {0.25f, 0.45f, 0.20f}, {0.06f, 0.08f, 0.05f}, 201})));
  m.pot = add_material(scene, textured_material(scene, "terracotta", terracotta_texture(128)));
  m.cloth = add_material(scene, plain_material("rug", {0.42f, 0.12f, 0.10f}));
  const std::array<vec3, 4> spines = {vec3(0.40f, 0.10f, 0.08f), vec3(0.10f, 0.22f, 0.30f), vec3(0.16f, 0.28f, 0.14f),
                                      vec3(0.62f, 0.50f, 0.30f)};
  for (size_t i = 0; i < spines.size(); ++i)
    m.books[i] = add_material(scene, plain_material("book_" + std::to_string(i), spines[i]));
  return m;
}

// Walls overlap at the corners and reach beyond floor and ceiling: no seam for light to leave by.
void add_room(Scene& scene, const Materials& m) {
  constexpr float k_thick = 0.25f, k_top = 2.0f * k_half.y;
  MeshPart walls = part_of(m.plaster), floor = part_of(m.floor), skirting = part_of(m.wood);
  const float x = k_half.x, z = k_half.z, t = k_thick;
  add_box(floor, {-x - t, -t, -z - t}, {x + t, 0, z + t}, 0.5f);
  add_box(walls, {-x - t, k_top, -z - t}, {x + t, k_top + t, z + t}, 0.5f);
  for (const float s : {-1.0f, 1.0f}) {
    const float inner_x = s * x, inner_z = s * z, outer_x = s * (x + t), outer_z = s * (z + t);
    add_box(walls, {std::min(inner_x, outer_x), -t, -z - t}, {std::max(inner_x, outer_x), k_top + t, z + t}, 0.5f);
    add_box(walls, {-x - t, -t, std::min(inner_z, outer_z)}, {x + t, k_top + t, std::max(inner_z, outer_z)}, 0.5f);
    add_box(skirting, {std::min(inner_x, s * (x - 0.02f)), 0, -z}, {std::max(inner_x, s * (x - 0.02f)), 0.12f, z}, 1.0f);
    add_box(skirting, {-x, 0, std::min(inner_z, s * (z - 0.02f))}, {x, 0.12f, std::max(inner_z, s * (z - 0.02f))}, 1.0f);
  }
  for (int i = 0; i < 4; ++i) {  // beams
    const float at = -3.3f + 2.2f * static_cast<float>(i);
    add_box(skirting, {at - 0.08f, k_top - 0.18f, -z}, {at + 0.08f, k_top, z}, 1.0f);
  }
  add_object(scene, "room", add_mesh(scene, "room", {walls, floor, skirting}));
  MeshPart rug = part_of(m.cloth);
  add_box(rug, {-1.5f, 0, -1.2f}, {2.3f, 0.015f, 1.4f}, 1.0f);
  add_object(scene, "rug", add_mesh(scene, "rug", {rug}));
}

void add_table(Scene& scene, const Materials& m) {
  MeshPart wood = part_of(m.wood);
  add_box(wood, {-0.9f, 0.72f, -0.5f}, {0.9f, 0.76f, 0.5f}, 1.0f);
  for (const float x : {-0.82f, 0.75f}) {
    for (const float z : {-0.43f, 0.36f}) add_box(wood, {x, 0, z}, {x + 0.07f, 0.72f, z + 0.07f}, 1.0f);
    add_box(wood, {x + 0.01f, 0.62f, -0.4f}, {x + 0.06f, 0.72f, 0.4f}, 1.0f);
  }
  add_object(scene, "table", add_mesh(scene, "table", {wood}), translation({k_pendant.x, 0, k_pendant.z}));

  MeshPart chair = part_of(m.dark_wood);
  add_box(chair, {-0.22f, 0.43f, -0.22f}, {0.22f, 0.47f, 0.22f}, 1.5f);
  for (const float x : {-0.21f, 0.17f}) {
    add_box(chair, {x, 0, -0.21f}, {x + 0.04f, 0.95f, -0.17f}, 1.5f);
    add_box(chair, {x, 0, 0.17f}, {x + 0.04f, 0.43f, 0.21f}, 1.5f);
  }
  for (int i = 0; i < 3; ++i) {
    const float y = 0.58f + 0.13f * static_cast<float>(i);
    add_box(chair, {-0.17f, y, -0.20f}, {0.17f, y + 0.06f, -0.18f}, 1.5f);
  }
  const int mesh = add_mesh(scene, "chair", {chair});
  const std::array<vec3, 4> places = {vec3(-0.1f, 0, -0.85f), vec3(1.0f, 0, -0.8f), vec3(0.0f, 0, 1.05f), vec3(1.75f, 0, 0.3f)};
  const std::array<double, 4> turns = {5.0, -8.0, 172.0, -75.0};
  for (size_t i = 0; i < places.size(); ++i) {
    add_object(scene, "chair_" + std::to_string(i), mesh, translation(places[i]) * rotation({0, 1, 0}, radians_of(turns[i])));
  }

  MeshPart stone = part_of(m.stone), clay = part_of(m.pot);
  const std::vector<vec2> vase = {{0.0f, 0.0f},   {0.06f, 0.0f},  {0.10f, 0.10f}, {0.07f, 0.20f}, {0.035f, 0.26f},
                                  {0.05f, 0.30f}, {0.03f, 0.30f}, {0.02f, 0.2f},  {0.0f, 0.2f}};
  add_lathe(clay, vase, 24, {2, 1});
  add_sphere(stone, {0.45f, 0.07f, 0.1f}, 0.07f, 24, 12, {1, 1});
  add_sphere(stone, {0.58f, 0.05f, 0.2f}, 0.05f, 20, 10, {1, 1});
  const std::vector<vec2> bowl = {{0.0f, 0.0f},   {0.05f, 0.0f},    {0.13f, 0.08f},
                                  {0.12f, 0.08f}, {0.045f, 0.015f}, {0.0f, 0.015f}};
  MeshPart dish;
  add_lathe(dish, bowl, 24, {2, 1});
  append(stone, dish, translation({-0.45f, 0, 0.05f}));
  add_object(scene, "tableware", add_mesh(scene, "tableware", {stone, clay}), translation({k_pendant.x, 0.76f, k_pendant.z}));
}

void add_bookshelf(Scene& scene, const Materials& m) {
  MeshPart wood = part_of(m.dark_wood);
  std::array<MeshPart, 4> books = {part_of(m.books[0]), part_of(m.books[1]), part_of(m.books[2]), part_of(m.books[3])};
  constexpr float k_width = 2.4f, k_height = 2.2f, k_depth = 0.32f;
  for (const float x : {0.0f, 0.5f * k_width - 0.015f, k_width - 0.03f})
    add_box(wood, {x, 0, 0}, {x + 0.03f, k_height, k_depth}, 1.0f);
  add_box(wood, {0, 0, -0.02f}, {k_width, k_height, 0.0f}, 1.0f);
  Random random(211);
  for (int shelf = 0; shelf <= 5; ++shelf) {
    const float y = 0.06f + 0.42f * static_cast<float>(shelf);
    add_box(wood, {0, y, 0}, {k_width, y + 0.03f, k_depth}, 1.0f);
    if (shelf == 5) break;
    for (float x = 0.05f; x < k_width - 0.12f;) {
      const float thick = random.range(0.02f, 0.06f), high = random.range(0.20f, 0.34f), deep = random.range(0.16f, 0.26f),
                  gap = random.unit();
      if (std::abs(x + 0.5f * thick - 0.5f * k_width) > 0.06f) {
        add_box(books[static_cast<size_t>(4.0f * random.unit())], {x, y + 0.03f, 0.02f},
                {x + thick, y + 0.03f + high, 0.02f + deep}, 1.0f);
      }
      x += thick + (gap < 0.10f ? 0.22f : 0.003f);
    }
  }
  add_object(scene, "bookshelf", add_mesh(scene, "bookshelf", {wood, books[0], books[1], books[2], books[3]}),
             translation({0.6f, 0, -3.48f}));
}

void add_columns(Scene& scene, const Materials& m) {
  MeshPart stone = part_of(m.stone);
  const std::vector<vec2> profile = {{0.0f, 0.0f},   {0.24f, 0.0f}, {0.24f, 0.12f}, {0.20f, 0.18f},
                                     {0.16f, 0.22f}, {0.16f, 1.2f}, {0.135f, 2.8f}, {0.17f, 2.85f},
                                     {0.20f, 2.95f}, {0.24f, 3.0f}, {0.24f, 3.4f}};
  add_lathe(stone, profile, 28, {4, 4});
  const int mesh = add_mesh(scene, "column", {stone});
  add_object(scene, "column_west", mesh, translation({-2.1f, 0, -0.9f}));
  add_object(scene, "column_east", mesh, translation({2.9f, 0, -0.9f}));
}

// Real bars before the spot lamp; an alpha-tested sheet and a ladder before the projector.
void add_gratings(Scene& scene, const Materials& m) {
  MeshPart iron = part_of(m.iron);
  constexpr float k_width = 1.7f, k_height = 1.5f;
  constexpr int k_bars = 12;
  for (int i = 0; i <= k_bars; ++i) {
    const float x = k_width * static_cast<float>(i) / k_bars;
    add_box(iron, {x - 0.009f, 0, -0.009f}, {x + 0.009f, k_height, 0.009f}, 1.0f);
  }
  for (const float y : {0.05f, 0.5f, 0.95f, 1.4f})
    add_box(iron, {-0.03f, y, -0.014f}, {k_width + 0.03f, y + 0.03f, 0.014f}, 1.0f);
  for (const float x : {-0.03f, k_width}) add_box(iron, {x, -1.1f, -0.02f}, {x + 0.04f, k_height, 0.02f}, 1.0f);
  add_object(scene, "grating", add_mesh(scene, "grating", {iron}),
             translation({-4.2f, 1.1f, -1.15f}) * rotation({0, 1, 0}, radians_of(28.0)));

  MeshPart sheet = part_of(m.grille);
  add_quad(sheet, {0, 0, 0}, {1.6f, 0, 0}, {1.6f, 1.6f, 0}, {0, 1.6f, 0}, {0, 0}, {1, 1});
  add_object(scene, "screen", add_mesh(scene, "screen", {sheet}),
             translation({-3.9f, 0, 2.6f}) * rotation({0, 1, 0}, radians_of(52.0)));

  MeshPart wood = part_of(m.wood);
  for (const float x : {0.0f, 0.42f}) add_box(wood, {x, 0, 0}, {x + 0.05f, 2.9f, 0.04f}, 1.0f);
  for (int i = 0; i < 9; ++i) {
    const float y = 0.25f + 0.3f * static_cast<float>(i);
    add_box(wood, {0.05f, y, 0.005f}, {0.42f, y + 0.035f, 0.035f}, 1.0f);
  }
  add_object(scene, "ladder", add_mesh(scene, "ladder", {wood}),
             translation({2.55f, 0, 0.35f}) * rotation({0, 1, 0}, radians_of(72.0)) * rotation({1, 0, 0}, radians_of(-14.0)));
}

void add_potted_plant(Scene& scene, const Materials& m) {
  MeshPart pot = part_of(m.pot), leaves = part_of(m.leaves);
  const std::vector<vec2> profile = {{0.0f, 0.0f},   {0.20f, 0.0f},  {0.28f, 0.40f}, {0.31f, 0.40f},
                                     {0.31f, 0.46f}, {0.26f, 0.46f}, {0.24f, 0.38f}, {0.0f, 0.38f}};
  add_lathe(pot, profile, 20, {2, 2});
  append(leaves, make_bush(m.leaves, 0.3f, 1.1f, 60, 0.55f, 221).front(), translation({0, 0.4f, 0}));
  add_object(scene, "potted_plant", add_mesh(scene, "potted_plant", {pot, leaves}), translation({-1.3f, 0, 2.5f}));
}

// A frame whose +Z is `direction`.
mat4 facing(const vec3& at, const vec3& direction) {
  vec3 a, b;
  orthonormal_basis(direction, a, b);
  return mat4(vec4(a, 0), vec4(b, 0), vec4(direction, 0), vec4(at, 1));
}

// What carries the lights. Bulbs lie around the lights themselves, so they cast nothing.
void add_fittings(Scene& scene, const Materials& m, const Light& spot, const Light& projector) {
  MeshPart shade = part_of(m.brass), cord = part_of(m.iron), bulb = part_of(m.bulb);
  const std::vector<vec2> cone = {{0.30f, -0.10f}, {0.26f, 0.0f}, {0.11f, 0.16f}, {0.07f, 0.19f}};
  add_lathe(shade, cone, 32, {1, 1});
  add_tube(cord, std::vector<vec3>{{0, 0.22f, 0}, {0, 3.4f - k_pendant.y, 0}}, std::vector<float>{0.006f, 0.006f}, 6, 1.0f);
  for (int i = 0; i < 3; ++i) {
    const vec2 at = 0.07f * vec2(unit_circle(radians_of(120.0 * i)));
    add_tube(cord, std::vector<vec3>{{at.x, 0.18f, at.y}, {0, 0.24f, 0}}, std::vector<float>{0.004f, 0.004f}, 5, 1.0f);
  }
  add_object(scene, "pendant", add_mesh(scene, "pendant", {shade, cord}), translation(k_pendant));
  add_sphere(bulb, {0, 0, 0}, 0.045f, 20, 10, {1, 1});
  add_object(scene, "pendant_bulb", add_mesh(scene, "pendant_bulb", {bulb}), translation(k_pendant));
  scene.objects.back().casts = false;

  // Tubes that open in the light's direction, just behind it.
  for (const Light* light : {&spot, &projector}) {
    MeshPart barrel = part_of(m.brass), lens = part_of(m.bulb);
    const float radius = light->kind == LightKind::projector ? light->beam_radius + 0.05f : 0.11f;
    add_tube(barrel, std::vector<vec3>{{0, 0, -0.30f}, {0, 0, -0.02f}}, std::vector<float>{0.8f * radius, radius}, 20, 1.0f);
    add_tube(lens, std::vector<vec3>{{0, 0, -0.019f}, {0, 0, -0.012f}}, std::vector<float>{0.8f * radius, 0.8f * radius}, 20,
             1.0f);
    add_object(scene, light->name + "_lamp", add_mesh(scene, light->name + "_lamp", {barrel, lens}),
               facing(light->position, light->direction));
    scene.objects.back().casts = false;
  }
}

}  // namespace

static Scene make_lamps(const BuiltinOptions&) {
  Scene scene;
  scene.name = "lamps";
  Light pendant, spot, projector;
  pendant.name = "pendant", pendant.kind = LightKind::point, pendant.position = k_pendant;
  pendant.colour = vec3(1.0f, 0.82f, 0.60f), pendant.intensity = 42.0f, pendant.radius = 0.045f, pendant.range = 9.0f;
  spot.name = "spot", spot.kind = LightKind::spot, spot.position = k_spot;
  spot.direction = glm::normalize(vec3(-1.3f, 0.0f, 1.3f) - k_spot);
  spot.colour = vec3(0.80f, 0.90f, 1.0f), spot.intensity = 130.0f, spot.radius = 0.06f;
  spot.inner_cone = static_cast<float>(radians_of(24.0)), spot.outer_cone = static_cast<float>(radians_of(34.0));
  projector.name = "projector", projector.kind = LightKind::projector, projector.position = k_projector;
  projector.direction = glm::normalize(vec3(-4.4f, 0.95f, 0.35f) - k_projector);
  projector.colour = vec3(1.0f, 0.55f, 0.45f), projector.intensity = 6.0f, projector.beam_radius = 0.5f;
  projector.angular_diameter = static_cast<float>(radians_of(1.0));

  const Materials m = add_materials(scene);
  for (const auto add : {add_room, add_table, add_bookshelf, add_columns, add_gratings, add_potted_plant}) add(scene, m);
  add_fittings(scene, m, spot, projector);
  scene.lights = {pendant, spot, projector};
  const auto camera = [&](const char* name, const vec3& eye, const vec3& target, double fov) {
    scene.cameras.push_back(look_at(name, eye, target, fov));
    scene.cameras.back().near = 0.05f, scene.cameras.back().far = 15.0f;
  };
  camera("default", {3.9f, 1.9f, 3.1f}, {-0.9f, 0.75f, -0.7f}, 65.0);
  camera("table", {-0.9f, 1.35f, 1.6f}, {0.6f, 0.7f, -0.3f}, 55.0);
  camera("grating", {0.3f, 1.7f, 2.9f}, {-3.4f, 0.9f, -0.9f}, 60.0);
  const std::vector<CameraPose> walk = {{{3.9f, 1.9f, 3.1f}, {-0.9f, 0.75f, -0.7f}},
                                        {{1.5f, 1.7f, 2.7f}, {-1.0f, 0.8f, -0.8f}},
                                        {{-1.0f, 1.6f, 1.5f}, {0.6f, 0.8f, -0.8f}},
                                        {{-2.6f, 1.6f, 0.5f}, {1.0f, 0.9f, -2.0f}}};
  const std::vector<CameraPose> fly = {{{3.9f, 3.0f, 3.0f}, {0.4f, 0.7f, 0.1f}},
                                       {{-0.5f, 2.9f, 3.1f}, {0.4f, 0.7f, 0.1f}},
                                       {{-3.6f, 2.8f, 1.5f}, {0.4f, 0.7f, 0.1f}},
                                       {{-3.0f, 2.8f, -1.9f}, {0.4f, 0.7f, 0.1f}}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_lamps() {
  return {"lamps",
          "A closed room with a pendant lamp, a spot lamp behind a grating and the beam of a projector; no sun.",
          {},
          make_lamps};
}

}  // namespace gnomon
