// town: streets to a far horizon, the load of published measurements: about 1000 objects, more than half of them instances, and
// a million triangles as drawn. A tower and houses behind the default viewer cast into the view.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/builtin/scenes/town/town_parts.h"
#include "scene/path.h"

namespace gnomon {
namespace {

constexpr int k_first_block = -2, k_blocks = 15;          // from behind the viewer to the horizon
constexpr float k_block = 84.0f, k_cross_street = 12.0f;  // metres along Z
constexpr float k_period = k_block + k_cross_street;
constexpr float k_front = 8.0f;    // of the houses along the main street
constexpr float k_outer = 58.0f;   // of those along the parallel streets, which face outward
constexpr float k_near = -205.0f;  // houses beyond it have fewer triangles

// South end of a block; its houses lie between that and `k_block` farther north (-Z).
float block_south(int block) { return -k_period * static_cast<float>(block); }

class Town {
 public:
  Town(Scene& scene, double detail) : scene_(scene), detail_(detail), m_(add_town_materials(scene)) {}

  void build() {
    add_ground();
    for (int i = 0; i < k_blocks; ++i) {
      const int block = k_first_block + i;
      for (const float side : {-1.0f, 1.0f}) add_houses(block, side);
      add_street_furniture(block);
      add_gardens(block);
    }
    place("tower", add_mesh(scene_, "tower", make_tower(m_, detail_)), {-25.5f, 0, 72.0f}, 6.0);
    place("crane", add_mesh(scene_, "crane", make_crane(m_, detail_)), {-27.0f, 0, -52.0f}, -14.0);
    const int water_tower = add_mesh(scene_, "water_tower", make_water_tower(m_, detail_));
    place("water_tower_near", water_tower, {31.0f, 0, -142.0f}, 20.0);
    place("water_tower_far", water_tower, {-33.0f, 0, -520.0f}, 50.0);
  }

 private:
  int leaves(int count) const { return std::max(6, static_cast<int>(count * detail_ + 0.5)); }

  void place(const std::string& name, int mesh, const vec3& at, double turn_degrees, float size = 1.0f) {
    add_object(scene_, name, mesh,
               translation(at) * rotation({0, 1, 0}, radians_of(turn_degrees)) * glm::scale(mat4(1.0f), vec3(size)));
  }
  // Several of one mesh, numbered.
  void place_numbered(const std::string& kind, int mesh, const vec3& at, double turn_degrees, float size = 1.0f) {
    place(kind + "_" + std::to_string(counts_[kind]++), mesh, at, turn_degrees, size);
  }

  void add_houses(int block, float side) {
    add_row(block, side, k_front, false);
    add_row(block, side, k_outer, true);
  }

  // Houses shoulder to shoulder along one side of a block.
  void add_row(int block, float side, float front, bool outward) {
    Random random(static_cast<uint32_t>(1000 + block * 8 + (side > 0 ? 1 : 0) + (outward ? 2 : 0)));
    float z = block_south(block);
    const float end = z - k_block;
    const int count = outward ? 4 : 6;
    for (int i = 0; i < count; ++i) {
      const float room = (z - end) / static_cast<float>(count - i), gap = outward ? random.range(2.0f, 5.0f) : 0.0f;
      const float width = i + 1 == count ? z - end : room * random.range(0.86f, 1.14f), middle = z - 0.5f * width;
      const HouseStyle style = style_of(random, width - gap, middle, outward);
      const auto& materials = m_.houses[static_cast<size_t>(random.unit() * static_cast<float>(m_.houses.size()))];
      const std::string name = "house_" + std::to_string(counts_["house"]++);
      const float setback = outward ? random.range(0.0f, 2.5f) : 0.0f;
      const double turn = (side > 0) == outward ? 90.0 : -90.0;
      place(name, add_mesh(scene_, name, make_house(materials, style)),
            {side * (front + (outward ? -setback : setback)), 0, middle}, turn);
      z -= width;
    }
  }

  HouseStyle style_of(Random& random, float width, float z, bool outward) const {
    HouseStyle style;
    const bool near = z > k_near, rich = near && detail_ >= 0.3, poor = detail_ < 0.1;
    style.width = width;
    style.depth = random.range(9.0f, 12.0f);
    style.floors = outward ? 1 + static_cast<int>(2.0f * random.unit()) : 2 + static_cast<int>(2.7f * random.unit());
    style.floor_height = random.range(2.9f, 3.4f);
    style.roof_rise = random.range(2.6f, 4.2f);
    style.bays = poor ? 2 : std::max(2, static_cast<int>(width / 2.9f));
    style.side_bays = poor ? 1 : outward ? 3 : 2;
    style.chimneys = 1 + static_cast<int>(1.6f * random.unit());
    style.balconies = rich && !outward && random.unit() < 0.6f;
    style.shop = !outward && random.unit() < 0.5f;
    style.joinery = rich;
    const double tiles = std::sqrt(detail_);
    const float per_metre = near ? 2.0f : 0.8f;
    style.tile_rows = static_cast<int>((near ? 9 : 4) * tiles);
    style.tile_columns = std::max(1, static_cast<int>(width * per_metre * tiles));
    style.seed = static_cast<uint32_t>(10000.0f * random.unit());
    return style;
  }

  void add_street_furniture(int block) {
    const float south = block_south(block);
    Random random(static_cast<uint32_t>(400 + block));
    for (int i = 0; i < 4; ++i) {
      const float z = south - 9.0f - 22.0f * static_cast<float>(i);
      for (const float side : {-1.0f, 1.0f}) {
        const float turn = 360.0f * random.unit();
        place_numbered("street_tree", mesh("street_tree_" + std::to_string((i + block + 2) % 2)), {side * 5.4f, 0.12f, z}, turn,
                       random.range(0.85f, 1.15f));
      }
    }
    for (int i = 0; i < 3; ++i) {
      const float side = (i + block) % 2 == 0 ? 1.0f : -1.0f;
      place_numbered("lamp_post", mesh("lamp_post"), {side * 4.6f, 0.12f, south - 19.0f - 27.0f * static_cast<float>(i)}, 0.0);
    }
    for (const float side : {-1.0f, 1.0f}) {
      place_numbered("bench", mesh("bench"), {side * 6.6f, 0.12f, south - 26.0f - 30.0f * random.unit()},
                     side > 0 ? -90.0 : 90.0);
      place_numbered("planter", mesh("planter"), {side * 6.9f, 0.12f, south - 4.0f}, 0.0);
      for (int i = 0; i < 2; ++i) {
        const std::string kind = "car_" + std::to_string(static_cast<int>(4.0f * random.unit()));
        const float z = south - 14.0f - 40.0f * static_cast<float>(i) - 16.0f * random.unit();
        place_numbered("car", mesh(kind), {side * 3.0f, 0.02f, z}, side > 0 ? 90.0 : -90.0);
      }
    }
  }

  void add_gardens(int block) {
    const float south = block_south(block);
    Random random(static_cast<uint32_t>(700 + block));
    for (const float side : {-1.0f, 1.0f}) {
      for (int i = 0; i < 4; ++i) {
        const float x = side * random.range(27.0f, 39.0f),
                    z = south - 10.0f - 21.0f * static_cast<float>(i) - random.range(-6.0f, 6.0f);
        const std::string kind = i % 3 == 2 ? "conifer" : "garden_tree";
        const float turn = 360.0f * random.unit();
        const bool beside_crane = side < 0 && glm::length(vec2(x + 27.0f, z + 52.0f)) < 6.0f;
        place_numbered(kind, mesh(kind), {beside_crane ? x - 8.0f : x, 0, z}, turn, random.range(0.8f, 1.2f));
      }
      for (int i = 0; i < 3; ++i) {
        place_numbered("fence", mesh("fence"), {side * 24.5f - 4.0f, 0, south - 20.0f - 22.0f * static_cast<float>(i)}, 0.0);
        place_numbered("fence", mesh("fence"), {side * 36.5f - 4.0f, 0, south - 20.0f - 22.0f * static_cast<float>(i)}, 0.0);
      }
      for (int i = 0; i < 3; ++i) {
        const float x = side * random.range(22.0f, 44.0f), z = south - 84.0f * random.unit(), size = random.range(0.7f, 1.4f);
        place_numbered("shrub", mesh("shrub"), {x, 0, z}, 0.0, size);
      }
    }
  }

  // Roads and pavements per block; under all a plain that rises to hills beyond the town.
  void add_ground() {
    MeshPart plain = part_of(m_.grass);
    constexpr double k_side = 4400.0, k_middle = -700.0;
    const int cells = std::max(24, static_cast<int>(110 * std::sqrt(detail_)));
    add_surface(plain, {cells, cells, false, false, vec2(500.0f)}, [](double u, double v) {
      const double x = k_side * (u - 0.5), z = k_middle + k_side * (0.5 - v);
      const float beyond = static_cast<float>(std::max(std::abs(x) - 130.0, std::max(z - 320.0, -1560.0 - z)));
      const double hills = smooth_step(0.0f, 900.0f, beyond) * (30.0 + 170.0 * fractal({0.0022 * x, 0.7, 0.0022 * z}, 4, 91));
      return glm::dvec3(x, hills - 0.06, z);
    });
    place("plain", add_mesh(scene_, "plain", {plain}), vec3(0.0f), 0.0);

    MeshPart road = part_of(m_.asphalt), pavement = part_of(m_.pavement), kerb = part_of(m_.kerb), paint = part_of(m_.stone);
    const auto strip = [](MeshPart& part, float x0, float x1, float z0, float z1, float y, float uv) {
      add_quad(part, {x0, y, z1}, {x1, y, z1}, {x1, y, z0}, {x0, y, z0}, {0, 0}, uv * vec2(x1 - x0, z1 - z0));
    };
    strip(road, -4.0f, 4.0f, -k_period, 0.0f, 0.02f, 0.3f);
    strip(road, -62.0f, -4.0f, -k_period, -k_block, 0.02f, 0.3f);
    strip(road, 4.0f, 62.0f, -k_period, -k_block, 0.02f, 0.3f);
    for (const float side : {-1.0f, 1.0f}) {
      const float inner = side * 4.3f, outer = side * (k_front + 0.5f), edge = side * 4.0f;
      strip(pavement, std::min(inner, outer), std::max(inner, outer), -k_block, 0.0f, 0.12f, 0.45f);
      add_box(kerb, {std::min(inner, edge), -0.1f, -k_block}, {std::max(inner, edge), 0.13f, 0.0f}, 0.5f);
      const float road_in = side * (k_outer + 4.0f), road_out = side * (k_outer + 10.0f);
      strip(road, std::min(road_in, road_out), std::max(road_in, road_out), -k_period, 0.0f, 0.03f, 0.3f);
    }
    for (int i = 0; i < 12; ++i) {
      const float z = -k_period + 8.0f * static_cast<float>(i);
      strip(paint, -0.07f, 0.07f, z, z + 3.0f, 0.03f, 1.0f);
    }
    for (int i = 0; i < 7; ++i) {  // a crossing
      const float x = -3.6f + 1.05f * static_cast<float>(i);
      strip(paint, x, x + 0.6f, -k_block + 1.0f, -k_block + 4.0f, 0.03f, 1.0f);
    }
    const int mesh = add_mesh(scene_, "street", {road, pavement, kerb, paint});
    for (int i = 0; i < k_blocks; ++i) place_numbered("street", mesh, {0, 0, block_south(k_first_block + i)}, 0.0);
  }

  // Shared meshes, made on first use.
  int mesh(const std::string& kind) {
    if (const auto found = meshes_.find(kind); found != meshes_.end()) return found->second;
    const auto make = [&]() -> std::vector<MeshPart> {
      if (kind == "street_tree_0") return make_broadleaf(m_.bark, m_.leaves, {7.5f, 2.3f, leaves(230), 0.95f, 7, 3});
      if (kind == "street_tree_1") return make_broadleaf(m_.bark, m_.leaves, {6.6f, 2.0f, leaves(200), 0.95f, 7, 4});
      if (kind == "garden_tree") return make_broadleaf(m_.bark, m_.leaves, {9.5f, 3.4f, leaves(260), 1.25f, 7, 5});
      if (kind == "conifer") return make_conifer(m_.bark, m_.needles, {11.0f, 3.0f, leaves(220), 1.5f, 7, 6});
      if (kind == "shrub") return make_bush(m_.shrub, 0.9f, 0.9f, leaves(60), 0.8f, 7);
      if (kind == "lamp_post") return make_lamp_post(m_, detail_);
      if (kind == "bench") return make_bench(m_);
      if (kind == "planter") return make_planter(m_, detail_);
      if (kind == "fence") return make_picket_fence(m_, 8.0f, detail_);
      const size_t car = static_cast<size_t>(kind.back() - '0');
      return make_car(m_, m_.cars[car], car == 3, detail_);
    };
    return meshes_[kind] = add_mesh(scene_, kind, make());
  }

  Scene& scene_;
  double detail_;
  TownMaterials m_;
  std::map<std::string, int> meshes_, counts_;
};

}  // namespace

TownMaterials add_town_materials(Scene& scene) {
  TownMaterials m;
  const Material plaster = textured_material(scene, "plaster", plaster_texture(256)),
                 stone = textured_material(scene, "limestone", limestone_texture(256));
  const Material masonry = textured_material(scene, "masonry", masonry_texture(256)),
                 wood = textured_material(scene, "wood", wood_texture(128));
  Material tiles = textured_material(scene, "terracotta", terracotta_texture(128));
  tiles.double_sided = true;  // tiles are sheets
  const auto add = [&](const Material& material) { return add_material(scene, material); };
  m.asphalt = add(tinted(stone, "asphalt", {0.26f, 0.26f, 0.28f}));
  m.pavement = add(textured_material(scene, "paving", paving_texture(256), {0.75f, 0.75f, 0.78f}));
  m.kerb = add(tinted(stone, "kerb", {0.55f, 0.54f, 0.53f}));
  m.stone = add(tinted(stone, "stone", {0.95f, 0.93f, 0.90f}));
  m.masonry = add(masonry);
  m.grass = add(textured_material(scene, "grass", soil_texture(256), {0.80f, 0.85f, 0.62f}));
  m.bark = add(textured_material(scene, "bark", bark_texture(128)));
  m.wood = add(tinted(wood, "wood", {0.85f, 0.78f, 0.70f}));
  m.iron = add(shiny(plain_material("iron", {0.03f, 0.035f, 0.04f}), 0.25f, 40.0f));
  m.glass = add(shiny(plain_material("glass", {0.03f, 0.05f, 0.07f}), 0.6f, 90.0f));
  m.paint = add(plain_material("crane_paint", {0.75f, 0.42f, 0.05f}));
  Material lamp = plain_material("lamp_glass", {0.8f, 0.78f, 0.7f});
  lamp.emissive = vec3(0.15f, 0.13f, 0.1f);
  m.lamp = add(lamp);
  m.leaves = add(cut_out_material(
      scene, "leaves", twig_texture(128, {5, 0.42f, 0.19f, 0.95f, {0.36f, 0.50f, 0.22f}, {0.08f, 0.09f, 0.05f}, 24})));
  m.needles = add(cut_out_material(
      scene, "needles", twig_texture(128, {14, 0.36f, 0.06f, 0.75f, {0.20f, 0.33f, 0.20f}, {0.05f, 0.06f, 0.04f}, 25})));
  m.shrub = add(cut_out_material(
      scene, "shrub", twig_texture(128, {6, 0.40f, 0.15f, 0.95f, {0.30f, 0.45f, 0.18f}, {0.07f, 0.08f, 0.05f}, 26})));
  m.roof = add(tiles);
  const int slate = add(tinted(tiles, "slate", {0.45f, 0.52f, 0.62f})),
            brick = add(tinted(masonry, "brick", {0.80f, 0.45f, 0.34f}));
  const std::vector<vec3> plasters = {
      {0.95f, 0.93f, 0.88f}, {0.98f, 0.80f, 0.55f}, {0.90f, 0.62f, 0.48f}, {0.62f, 0.78f, 0.95f}, {0.72f, 0.88f, 0.72f}};
  const std::vector<vec3> joinery = {
      {0.25f, 0.42f, 0.35f}, {0.40f, 0.20f, 0.14f}, {0.22f, 0.33f, 0.52f}, {0.85f, 0.84f, 0.80f}, {0.35f, 0.36f, 0.38f}};
  const std::vector<vec3> cloths = {
      {0.70f, 0.10f, 0.08f}, {0.10f, 0.30f, 0.20f}, {0.85f, 0.80f, 0.70f}, {0.12f, 0.20f, 0.45f}, {0.85f, 0.55f, 0.10f}};
  for (size_t i = 0; i < plasters.size(); ++i) {
    const std::string number = std::to_string(i);
    HouseMaterials house;
    house.wall = add(tinted(i == 2 ? masonry : i % 3 == 0 ? stone : plaster, "house_wall_" + number, plasters[i]));
    house.trim = m.stone, house.brick = brick, house.glass = m.glass, house.iron = m.iron;
    house.roof = i % 3 == 0 ? slate : m.roof;
    house.wood = add(tinted(wood, "joinery_" + number, joinery[i]));
    Material cloth = plain_material("cloth_" + number, cloths[i]);
    cloth.double_sided = true;
    house.cloth = add(cloth);
    m.houses.push_back(house);
  }
  const std::vector<vec3> paints = {{0.55f, 0.04f, 0.04f}, {0.10f, 0.20f, 0.45f}, {0.75f, 0.76f, 0.78f}, {0.85f, 0.83f, 0.75f}};
  for (size_t i = 0; i < paints.size(); ++i)
    m.cars.push_back(add(shiny(plain_material("car_paint_" + std::to_string(i), paints[i]), 0.5f, 80.0f)));
  return m;
}

static Scene make_town(const BuiltinOptions& options) {
  Scene scene;
  scene.name = "town";
  Town(scene, options.at("detail")).build();
  scene.lights.push_back(sun_light("sun", vec3(0.27f, -0.55f, -0.78f), vec3(1.0f, 0.90f, 0.76f), 3.0f));
  const auto camera = [&](const char* name, const vec3& eye, const vec3& target, double fov, float far) {
    scene.cameras.push_back(look_at(name, eye, target, fov));
    scene.cameras.back().near = 0.2f, scene.cameras.back().far = far;
  };
  camera("default", {-1.2f, 7.5f, 13.0f}, {0.3f, 1.5f, -30.0f}, 52.0, 1800.0f);
  camera("street", {-6.0f, 1.75f, 4.0f}, {1.5f, 2.2f, -40.0f}, 60.0, 1800.0f);
  camera("roofs", {30.0f, 42.0f, 60.0f}, {-4.0f, 0.0f, -110.0f}, 50.0, 2200.0f);
  camera("garden", {34.0f, 2.0f, -6.0f}, {29.0f, 2.0f, -60.0f}, 60.0, 1800.0f);
  const std::vector<CameraPose> walk = {{{-1.5f, 1.75f, 14.0f}, {-1.0f, 2.0f, -30.0f}},
                                        {{-1.0f, 1.75f, -20.0f}, {1.0f, 3.0f, -60.0f}},
                                        {{1.0f, 1.75f, -60.0f}, {-2.0f, 4.0f, -110.0f}},
                                        {{0.0f, 1.75f, -120.0f}, {0.0f, 2.0f, -200.0f}}};
  const std::vector<CameraPose> fly = {{{2.0f, 20.0f, 90.0f}, {0.0f, 5.0f, 0.0f}},
                                       {{12.0f, 30.0f, 40.0f}, {0.0f, 0.0f, -40.0f}},
                                       {{-5.0f, 48.0f, -40.0f}, {0.0f, 0.0f, -140.0f}},
                                       {{5.0f, 24.0f, -160.0f}, {0.0f, 0.0f, -280.0f}},
                                       {{0.0f, 14.0f, -260.0f}, {0.0f, 2.0f, -420.0f}}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_town() {
  return {"town",
          "Streets to a far horizon: a thousand objects, most of them instances, and a million triangles; a tower behind the "
          "viewer casts "
          "into the view.",
          {{"detail", 1.0, 0.02, 4.0, "Triangles of roofs, leaves and ornaments as a fraction of those of the full town"}},
          make_town};
}

}  // namespace gnomon
