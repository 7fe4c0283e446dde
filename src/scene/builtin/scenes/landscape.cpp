// landscape: four kilometres of hills with woods and farms, three suns of different colour, and the parallel beam of a giant
// projector on a hill. What strains maps here is the distance between the nearest and the farthest shadow.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/house.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/path.h"

namespace gnomon {
namespace {

constexpr double k_side = 4096.0;  // metres
constexpr int k_tiles = 8;         // the ground is this many objects in each direction, so that culling has work

// A valley along Z through the middle, hills that grow to mountains outward.
double height_at(double x, double z) {
  const double bend = 90.0 * sine(0.0031 * z) + 40.0 * sine(0.0077 * z + 1.3), from_valley = std::abs(x - bend);
  const double up = smooth_step(60.0f, 800.0f, static_cast<float>(from_valley));
  const double ridge = 1.0 - std::abs(2.0 * fractal({0.0011 * x, 3.1, 0.0011 * z}, 5, 51) - 1.0);
  const double rolling = fractal({0.006 * x, 7.7, 0.006 * z}, 4, 57) - 0.5;
  const double small = fractal({0.05 * x, 1.7, 0.05 * z}, 2, 59) - 0.5;
  return 430.0 * up * ridge * ridge + (10.0 + 34.0 * up) * rolling + 1.2 * small;
}

vec3 on_ground(double x, double z, double sunk = 0.0) { return vec3(glm::dvec3(x, height_at(x, z) - sunk, z)); }

double slope_at(double x, double z) {
  const double dx = height_at(x + 4, z) - height_at(x - 4, z), dz = height_at(x, z + 4) - height_at(x, z - 4);
  return std::sqrt(dx * dx + dz * dz) / 8.0;
}

int scaled(int count, double detail, int least) { return std::max(least, static_cast<int>(count * detail + 0.5)); }

mat4 placed(const vec3& at, double turn_degrees, float size) {
  return translation(at) * rotation({0, 1, 0}, radians_of(turn_degrees)) * glm::scale(mat4(1.0f), vec3(size));
}

// Rock where it is steep, snow on the heights, by colours of vertices.
void paint(MeshPart& part) {
  for (size_t i = 0; i < part.positions.size(); ++i) {
    const vec3& p = part.positions[i];
    const float uneven = static_cast<float>(noise({0.03 * p.x, 0.0, 0.03 * p.z}, 73)), level = part.normals[i].y;
    const vec3 rock = glm::mix(vec3(0.95f, 0.80f, 1.0f), vec3(1.0f), smooth_step(0.70f, 0.84f, level + 0.08f * uneven));
    const float snow = smooth_step(215.0f, 275.0f, p.y + 60.0f * uneven) * smooth_step(0.55f, 0.75f, level);
    part.colours[i] = vec4(glm::mix(rock, vec3(4.0f, 4.4f, 8.0f), snow), 1.0f);
  }
}

void add_ground(Scene& scene, double detail) {
  const int material = add_material(scene, textured_material(scene, "meadow", soil_texture(512), {0.80f, 0.88f, 0.62f}));
  const int cells = std::max(12, static_cast<int>(54 * std::sqrt(detail)));
  for (int row = 0; row < k_tiles; ++row) {
    for (int column = 0; column < k_tiles; ++column) {
      MeshPart part = part_of(material);
      const double tile = k_side / k_tiles, x0 = -0.5 * k_side + tile * column, z0 = 0.5 * k_side - tile * row;
      add_surface(part, {cells, cells, false, false, vec2(static_cast<float>(tile / 16.0))}, [&](double u, double v) {
        return glm::dvec3(x0 + tile * u, height_at(x0 + tile * u, z0 - tile * v), z0 - tile * v);
      });
      const std::string name = "ground_" + std::to_string(row) + "_" + std::to_string(column);
      add_object(scene, name, add_mesh(scene, name, {std::move(part)}));
      paint(scene.meshes.back().parts.front());
    }
  }
}

// Woods where noise says so, dense near the viewer's valley, thinner in the distance; none on rock faces.
void add_trees(Scene& scene, double detail) {
  const int bark = add_material(scene, textured_material(scene, "bark", bark_texture(128)));
  const int leaves = add_material(
      scene, cut_out_material(scene, "leaves",
                              twig_texture(128, {5, 0.42f, 0.19f, 0.95f, {0.40f, 0.50f, 0.22f}, {0.08f, 0.09f, 0.05f}, 34})));
  const int needles = add_material(
      scene, cut_out_material(scene, "needles",
                              twig_texture(128, {14, 0.36f, 0.06f, 0.75f, {0.20f, 0.33f, 0.20f}, {0.05f, 0.06f, 0.04f}, 35})));
  const std::array<int, 4> meshes = {
      add_mesh(scene, "oak", make_broadleaf(bark, leaves, {12.0f, 4.6f, scaled(120, detail, 12), 2.6f, 6, 41})),
      add_mesh(scene, "birch", make_broadleaf(bark, leaves, {10.0f, 2.8f, scaled(96, detail, 12), 1.8f, 6, 42})),
      add_mesh(scene, "spruce", make_conifer(bark, needles, {17.0f, 3.8f, scaled(120, detail, 12), 3.0f, 6, 43})),
      add_mesh(scene, "fir", make_conifer(bark, needles, {12.0f, 3.0f, scaled(100, detail, 12), 2.5f, 6, 44}))};
  Random random(61);
  int placed_trees = 0;
  constexpr int k_trees = 2000;
  for (int attempt = 0; attempt < 40 * k_trees && placed_trees < k_trees; ++attempt) {
    // Two of three on the slopes that the first camera looks at.
    const bool far_away = placed_trees % 3 == 0;
    const double reach = far_away ? 0.46 * k_side : 400.0, u = 2.0 * random.unit() - 1.0, v = 2.0 * random.unit() - 1.0;
    const double x = reach * u, z = reach * v - (far_away ? 0.0 : 330.0);
    const double wood = fractal({0.008 * x, 4.4, 0.008 * z}, 3, 67), chance = random.unit();
    const float kind = random.unit(), size = random.range(0.7f, 1.25f), turn = 360.0f * random.unit();
    if (chance > smooth_step(0.42f, 0.56f, static_cast<float>(wood)) + 0.03 || slope_at(x, z) > 0.7) continue;
    if (glm::length(glm::dvec2(x - 5.0, z - 45.0)) < 26.0) continue;  // not in the first camera's face
    const bool high = height_at(x, z) > 70.0;
    const size_t species = high ? (kind < 0.7f ? 2u : 3u) : (kind < 0.45f ? 0u : kind < 0.75f ? 1u : kind < 0.9f ? 3u : 2u);
    add_object(scene, "tree_" + std::to_string(placed_trees++), meshes[species], placed(on_ground(x, z, 0.2), turn, size));
  }
}

// Farms in the valley, and a hamlet on a rise.
void add_houses(Scene& scene, double detail) {
  const Material tiles = textured_material(scene, "terracotta", terracotta_texture(128)),
                 wood = textured_material(scene, "wood", wood_texture(128));
  const Material plaster = textured_material(scene, "plaster", plaster_texture(256)),
                 stone = textured_material(scene, "limestone", limestone_texture(128));
  Material roof = tiles;
  roof.double_sided = true;
  HouseMaterials m;
  m.roof = add_material(scene, roof);
  m.wood = add_material(scene, wood);
  m.trim = add_material(scene, stone);
  m.brick = add_material(scene, tinted(stone, "brick", {0.6f, 0.33f, 0.25f}));
  m.glass = add_material(scene, shiny(plain_material("glass", {0.03f, 0.05f, 0.07f}), 0.6f, 90.0f));
  m.iron = m.cloth = m.wood;
  std::array<int, 4> meshes;
  for (size_t i = 0; i < meshes.size(); ++i) {
    const auto n = static_cast<float>(i);
    m.wall = add_material(scene, tinted(plaster, "house_wall_" + std::to_string(i),
                                        i % 2 == 0 ? vec3(0.95f, 0.92f, 0.85f) : vec3(0.85f, 0.66f, 0.50f)));
    HouseStyle style;
    style.width = 9.0f + 3.0f * n, style.depth = 8.0f + n, style.floors = 1 + static_cast<int>(i % 2),
    style.bays = 3 + static_cast<int>(i);
    style.roof_rise = 3.2f + 0.4f * n, style.joinery = detail >= 0.3, style.seed = 90 + static_cast<uint32_t>(i);
    style.tile_rows = static_cast<int>(8 * std::sqrt(detail)),
    style.tile_columns = std::max(1, static_cast<int>(16 * std::sqrt(detail)));
    meshes[i] = add_mesh(scene, "house_" + std::to_string(i), make_house(m, style));
  }
  Random random(71);
  int count = 0;
  for (int attempt = 0; attempt < 2000 && count < 70; ++attempt) {
    const bool hamlet = count < 34;
    const double x = hamlet ? random.range(-110.0f, 130.0f) : random.range(-900.0f, 900.0f);
    const double z = hamlet ? random.range(-260.0f, -90.0f) : random.range(-1800.0f, 300.0f);
    const auto kind = static_cast<size_t>(4.0f * random.unit());
    const float turn = 360.0f * random.unit();
    if (slope_at(x, z) > 0.18 || glm::length(glm::dvec2(x - 5.0, z - 50.0)) < 60.0) continue;
    const vec3 at = on_ground(x, z, 0.0);
    const auto too_close = [&](const Object& o) {
      return o.name.starts_with("house") && glm::length(vec3(o.world_from_object[3]) - at) < 21.0f;
    };
    if (std::any_of(scene.objects.begin(), scene.objects.end(), too_close)) continue;
    // On the lowest corner's height, so that no wall hangs in the air.
    float low = at.y;
    for (const double dx : {-8.0, 8.0}) {
      for (const double dz : {-8.0, 8.0}) low = std::min(low, on_ground(x + dx, z + dz).y);
    }
    add_object(scene, "house_" + std::to_string(count++), meshes[kind], placed({at.x, low - 0.1f, at.z}, turn, 1.0f));
  }
}

}  // namespace

static Scene make_landscape(const BuiltinOptions& options) {
  Scene scene;
  scene.name = "landscape";
  const double detail = options.at("detail");
  add_ground(scene, detail);
  add_houses(scene, detail);
  add_trees(scene, detail);

  scene.lights.push_back(sun_light("sun", {0.66f, -0.60f, -0.45f}, {1.0f, 0.88f, 0.70f}, 3.0f));
  scene.lights.push_back(sun_light("sun_blue", {-0.55f, -0.62f, -0.40f}, {0.45f, 0.62f, 1.0f}, 1.2f));
  scene.lights.push_back(sun_light("sun_red", {0.25f, -0.24f, 0.90f}, {1.0f, 0.35f, 0.18f}, 0.9f));
  Light beam;
  beam.name = "projector";
  beam.kind = LightKind::projector;
  beam.beam_radius = 45.0f;
  const vec3 target = on_ground(20.0, -170.0);
  beam.direction = glm::normalize(vec3(0.35f, -0.80f, -0.50f));
  beam.position = target - 420.0f * beam.direction;
  beam.colour = vec3(0.75f, 1.0f, 0.85f), beam.intensity = 5.0f;
  beam.angular_diameter = static_cast<float>(radians_of(0.8));
  scene.lights.push_back(beam);

  const auto camera = [&](const char* name, const vec3& eye, const vec3& target_ws, double fov, float near, float far) {
    scene.cameras.push_back(look_at(name, eye, target_ws, fov));
    scene.cameras.back().near = near, scene.cameras.back().far = far;
  };
  const vec3 hamlet = on_ground(15.0, -170.0);
  camera("default", on_ground(5.0, 60.0) + vec3(0, 17, 0), hamlet + vec3(0, 10, 0), 52.0, 0.5f, 3500.0f);
  camera("ground", on_ground(30.0, -95.0) + vec3(0, 1.8f, 0), hamlet + vec3(0, 4, 0), 60.0, 0.2f, 2500.0f);
  camera("summit", vec3(330.0f, 330.0f, 560.0f), on_ground(40.0, -400.0), 50.0, 1.0f, 4500.0f);
  const auto above = [](double x, double z, float height) { return on_ground(x, z) + vec3(0, height, 0); };
  const std::vector<CameraPose> walk = {{above(5.0, 60.0, 12.0f), hamlet},
                                        {above(0.0, 10.0, 6.0f), hamlet},
                                        {above(-5.0, -40.0, 3.0f), hamlet},
                                        {above(10.0, -85.0, 3.0f), above(40.0, -260.0, 5.0f)}};
  const std::vector<CameraPose> fly = {{above(5.0, 120.0, 40.0f), hamlet},
                                       {above(-120.0, -120.0, 90.0f), above(0.0, -400.0, 0.0f)},
                                       {above(0.0, -420.0, 120.0f), above(60.0, -800.0, 20.0f)},
                                       {above(140.0, -700.0, 140.0f), above(60.0, -1200.0, 60.0f)},
                                       {above(60.0, -1100.0, 120.0f), above(0.0, -1700.0, 100.0f)}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_landscape() {
  return {"landscape",
          "Four kilometres of hills with woods and houses under three suns, and the beam of a projector on a hamlet.",
          {{"detail", 1.0, 0.02, 4.0, "Triangles of ground, leaves and roofs as a fraction of those of the full landscape"}},
          make_landscape};
}

}  // namespace gnomon
