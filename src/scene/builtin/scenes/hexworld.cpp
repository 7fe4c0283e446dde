// hexworld: hexagonal columns in the manner of voxel worlds, with plants, a gorge, and a cave whose mouth faces the sun. On its
// walls the shadows of plants and of the rock overlap: where filters that keep only moments of depth let light through.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/path.h"

namespace gnomon {
namespace {

constexpr double k_root3 = 1.7320508075688772;
constexpr float k_cell = 0.6f;      // radius of a column's corners [m]
constexpr float k_step = 0.3f;      // heights are multiples of it [m]
constexpr float k_bottom = -13.5f;  // underside of the world [m]
constexpr float k_chunk = 16.0f;    // columns of a square of this side are one object [m]

float stepped(double height) { return k_step * static_cast<float>(std::floor(height / k_step + 0.5)); }

enum Ground : uint32_t { k_grass, k_soil, k_rock, k_sand, k_ground_count };

struct Span {
  float low, high;
  bool solid() const { return high > low; }
};

// Rock from the bottom up and, over a hollow, a roof.
struct Column {
  bool exists = false;
  Span ground = {0, 0}, roof = {0, 0};
  Ground top = k_grass;
};

glm::dvec2 centre_of(int q, int r) { return {1.5 * k_cell * q, k_root3 * k_cell * (r + 0.5 * q)}; }

// The cave: a hall in a hill, open to +Z, with a hole in its roof.
constexpr double k_cave_x = -11.0, k_cave_z = -9.0, k_cave_floor = 1.8;
bool in_cave(double x, double z) {
  const double across = (x - k_cave_x) / (4.6 + 1.4 * (noise({0.35 * x, 2.0, 0.35 * z}, 131) - 0.5)), along = z - k_cave_z;
  if (along > 12.0 || along < -7.0) return false;
  const double narrow = along > 6.0 ? 0.85 : along < -3.0 ? 1.0 - 0.12 * (-3.0 - along) : 1.0;
  return std::abs(across) < narrow;
}
double ceiling_at(double x, double z) {
  const double along = z - k_cave_z, arch = (x - k_cave_x) / 4.6;
  return k_cave_floor + 5.6 - 1.9 * arch * arch + 0.10 * along + 0.8 * (noise({0.5 * x, 8.0, 0.5 * z}, 137) - 0.5);
}
bool in_skylight(double x, double z) { return glm::length(glm::dvec2(x + 12.6, z + 11.5)) < 1.35; }

double gorge_distance(double x, double z) { return std::abs(x - (13.0 + 4.5 * sine(0.11 * z) + 1.2 * sine(0.31 * z + 2.0))); }

Column column_at(double x, double z) {
  Column column;
  column.exists = true;
  const double rolling = 2.2 + 4.2 * (fractal({0.045 * x, 0.0, 0.045 * z}, 4, 141) - 0.4);
  const double dx = (x - k_cave_x) / 11.0, dz = (z - k_cave_z) / 12.0, from_hill = std::sqrt(dx * dx + dz * dz);
  const double hill = smooth_step(0.0f, 0.75f, static_cast<float>(1.15 - from_hill));
  double height = rolling + hill * (9.0 + 2.5 * (noise({0.4 * x, 3.0, 0.4 * z}, 143) - 0.5));
  const double spires = fractal({0.09 * x, 9.0, 0.09 * z}, 2, 149);
  if (spires > 0.69 && hill <= 0.0) height += 26.0 * (spires - 0.69) + 1.2;  // lone rocks
  const double to_gorge = gorge_distance(x, z), wide = 2.0 + 0.9 * noise({0.2 * x, 6.0, 0.2 * z}, 151);
  const float chance = unit_random(static_cast<int>(std::floor(x * 50.0)), static_cast<int>(std::floor(z * 50.0)), 157u);

  column.top = height > 8.0 || spires > 0.69 ? k_rock : rolling < 1.35 ? k_sand : k_grass;
  if (column.top == k_grass && chance < 0.06f) height += k_step;
  if (to_gorge < wide) {  // steep walls with a ledge here and there
    height = chance < 0.10f && to_gorge > wide - 0.9 ? -3.0 : -10.5 + 1.2 * noise({0.5 * x, 1.0, 0.5 * z}, 163);
    column.top = height < -6.0 ? k_sand : k_rock;
  }
  column.ground = {k_bottom, std::max(stepped(height), k_bottom + k_step)};
  if (in_cave(x, z)) {
    const float floor = stepped(k_cave_floor + 0.5 * (noise({0.6 * x, 5.0, 0.6 * z}, 167) - 0.5)),
                ceiling = stepped(ceiling_at(x, z));
    if (column.ground.high > floor) {
      if (column.ground.high >= ceiling + 2.0f * k_step && !in_skylight(x, z)) column.roof = {ceiling, column.ground.high};
      column.ground.high = floor;
      if (!column.roof.solid()) column.top = k_soil;
    }
  }
  return column;
}

class HexWorld {
 public:
  HexWorld(Scene& scene, int radius)
      : scene_(scene), radius_(radius), columns_(static_cast<size_t>(2 * radius + 1) * (2 * radius + 1)) {
    for_cells([&](int q, int r) {
      const glm::dvec2 at = centre_of(q, r);
      columns_[index(q, r)] = column_at(at.x, at.y);
    });
  }

  void add_columns(const std::array<int, k_ground_count>& materials) {
    std::map<std::pair<int, int>, std::array<MeshPart, k_ground_count>> chunks;
    for_cells([&](int q, int r) {
      const glm::dvec2 at = centre_of(q, r);
      const auto chunk = std::pair(static_cast<int>(std::floor(at.x / k_chunk)), static_cast<int>(std::floor(at.y / k_chunk)));
      add_column(chunks[chunk], q, r);
    });
    for (auto& [place, parts] : chunks) {
      std::vector<MeshPart> filled;
      for (size_t i = 0; i < parts.size(); ++i) {
        parts[i].material = materials[i];
        if (!parts[i].indices.empty()) filled.push_back(std::move(parts[i]));
      }
      const std::string name = "columns_" + std::to_string(chunk_count_++);
      add_object(scene_, name, add_mesh(scene_, name, std::move(filled)));
    }
  }

  // Calls with the column and its centre, top of the ground under an open sky or a roof.
  template <class Function>
  void for_columns(const Function& function) const {
    for_cells([&](int q, int r) {
      const glm::dvec2 at = centre_of(q, r);
      function(columns_[index(q, r)], static_cast<float>(at.x), static_cast<float>(at.y), q, r);
    });
  }

 private:
  size_t index(int q, int r) const {
    return static_cast<size_t>(q + radius_) * (2 * radius_ + 1) + static_cast<size_t>(r + radius_);
  }

  template <class Function>
  void for_cells(const Function& function) const {
    for (int q = -radius_; q <= radius_; ++q) {
      for (int r = std::max(-radius_, -q - radius_); r <= std::min(radius_, -q + radius_); ++r) function(q, r);
    }
  }

  const Column* neighbour(int q, int r) const {
    const bool inside = std::abs(q) <= radius_ && std::abs(r) <= radius_ && std::abs(q + r) <= radius_;
    return inside ? &columns_[index(q, r)] : nullptr;
  }

  // Corner k of a column, from the lattice of half cells, so that neighbours agree bit for bit.
  static vec2 corner(int q, int r, int k) {
    constexpr std::array<int, 6> x = {2, 1, -1, -2, -1, 1}, z = {0, 1, 1, 0, -1, -1};
    const int cx = 3 * q + x[static_cast<size_t>(k)], cz = 2 * r + q + z[static_cast<size_t>(k)];
    return {static_cast<float>(0.5 * k_cell * cx), static_cast<float>(0.5 * k_root3 * k_cell * cz)};
  }

  static void add_hexagon(MeshPart& part, int q, int r, float y, bool up) {
    const auto first = static_cast<uint32_t>(part.positions.size());
    for (int k = 0; k < 6; ++k) {
      const vec2 p = corner(q, r, k);
      add_vertex(part, {p.x, y, p.y}, {0, up ? 1 : -1, 0}, 0.45f * p);
    }
    for (uint32_t k = 1; k < 5; ++k)
      up ? add_triangle(part, first, first + k + 1, first + k) : add_triangle(part, first, first + k, first + k + 1);
  }

  static void add_side(MeshPart& part, int q, int r, int k, const Span& span) {
    const vec2 a = corner(q, r, (k + 1) % 6), b = corner(q, r, k);
    const float u = 0.45f * k_cell * static_cast<float>(k);
    add_quad(part, {a.x, span.low, a.y}, {b.x, span.low, b.y}, {b.x, span.high, b.y}, {a.x, span.high, a.y},
             {u, -0.45f * span.high}, {u + 0.45f * k_cell, -0.45f * span.low});
  }

  // What of `span` the neighbour leaves bare.
  static std::vector<Span> bare(const Span& span, const Column* beside) {
    std::vector<Span> left = {span};
    if (!beside) return left;
    for (const Span& other : {beside->ground, beside->roof}) {
      if (!other.solid()) continue;
      std::vector<Span> rest;
      for (const Span& s : left) {
        if (const Span below{s.low, std::min(s.high, other.low)}; below.solid()) rest.push_back(below);
        if (const Span above{std::max(s.low, other.high), s.high}; above.solid()) rest.push_back(above);
      }
      left = rest;
    }
    return left;
  }

  void add_column(std::array<MeshPart, k_ground_count>& parts, int q, int r) {
    constexpr std::array<std::array<int, 2>, 6> k_beside = {{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
    const Column& column = columns_[index(q, r)];
    const Ground surface = column.roof.solid() && column.top == k_grass ? k_grass : column.top;
    add_hexagon(parts[column.roof.solid() ? k_rock : column.top], q, r, column.ground.high, true);
    add_hexagon(parts[k_rock], q, r, column.ground.low, false);
    if (column.roof.solid()) {
      add_hexagon(parts[surface], q, r, column.roof.high, true);
      add_hexagon(parts[k_rock], q, r, column.roof.low, false);
    }
    for (int k = 0; k < 6; ++k) {
      const auto [dq, dr] = k_beside[static_cast<size_t>(k)];
      for (const Span& solid : {column.ground, column.roof}) {
        if (!solid.solid()) continue;
        const bool under_sky = !column.roof.solid() || solid.low == column.roof.low;
        for (const Span& span : bare(solid, neighbour(q + dq, r + dr))) {
          // Soil under grass, rock below it.
          const float seam = under_sky && surface != k_rock ? std::max(span.low, solid.high - 0.9f) : span.high;
          if (const Span deep{span.low, std::min(seam, span.high)}; deep.solid()) add_side(parts[k_rock], q, r, k, deep);
          if (const Span shallow{std::max(seam, span.low), span.high}; shallow.solid())
            add_side(parts[surface == k_sand ? k_sand : k_soil], q, r, k, shallow);
        }
      }
    }
  }

  Scene& scene_;
  int radius_, chunk_count_ = 0;
  std::vector<Column> columns_;
};

int scaled(int count, double detail) { return std::max(3, static_cast<int>(count * detail + 0.5)); }

void add_plants(Scene& scene, const HexWorld& world, double detail) {
  const auto twigs = [&](const char* name, const TwigStyle& style) {
    return add_material(scene, cut_out_material(scene, name, twig_texture(128, style)));
  };
  const int blade = twigs("grass_blades", {4, 0.75f, 0.06f, 0.30f, {0.42f, 0.58f, 0.20f}, {0.08f, 0.09f, 0.05f}, 171});
  const int fern = twigs("fern", {9, 0.40f, 0.09f, 1.05f, {0.25f, 0.45f, 0.16f}, {0.06f, 0.08f, 0.04f}, 172});
  const int leaf = twigs("leaves", {5, 0.42f, 0.19f, 0.95f, {0.36f, 0.50f, 0.22f}, {0.08f, 0.09f, 0.05f}, 173});
  const int bark = add_material(scene, textured_material(scene, "bark", bark_texture(128)));
  const int tuft_mesh = add_mesh(scene, "tuft", make_bush(blade, 0.3f, 0.05f, scaled(9, detail), 0.7f, 181));
  const int fern_mesh = add_mesh(scene, "fern", make_bush(fern, 0.35f, 0.1f, scaled(14, detail), 1.1f, 182));
  const int reed_mesh = add_mesh(scene, "tall_fern", make_bush(fern, 0.4f, 1.6f, scaled(26, detail), 1.3f, 183));
  const int vine_mesh = add_mesh(scene, "vine", make_bush(leaf, 0.25f, 1.4f, scaled(22, detail), 0.6f, 184));
  const int tree_mesh = add_mesh(scene, "tree", make_broadleaf(bark, leaf, {5.2f, 1.8f, scaled(170, detail), 0.85f, 7, 185}));
  int count = 0;
  const auto plant = [&](const char* kind, int mesh, const vec3& at, double turn, float size, bool hanging = false) {
    const mat4 flip = hanging ? rotation({1, 0, 0}, radians_of(180.0)) : mat4(1.0f);
    add_object(scene, std::string(kind) + "_" + std::to_string(count++), mesh,
               translation(at) * rotation({0, 1, 0}, radians_of(turn)) * flip * glm::scale(mat4(1.0f), vec3(size)));
  };
  world.for_columns([&](const Column& column, float x, float z, int q, int r) {
    const float chance = unit_random(q, r, 191u), size = 0.75f + 0.5f * unit_random(q, r, 192u),
                turn = 360.0f * unit_random(q, r, 193u);
    const float along = z - static_cast<float>(k_cave_z);
    const bool cave = in_cave(x, z);
    if (column.roof.solid()) {
      const float top = column.roof.high;
      if (along > 1.5f && chance < 0.13f) plant("tall_fern", reed_mesh, {x, column.ground.high, z}, turn, 0.75f * size);
      if (along > -1.0f && chance > 0.86f) plant("vine", vine_mesh, {x, column.roof.low, z}, turn, size, true);
      if (chance > 0.4f && chance < 0.6f) plant("tuft", tuft_mesh, {x, top, z}, turn, size);
      if (glm::length(vec2(x + 12.6f, z + 11.5f)) < 2.2f && chance < 0.6f) plant("fern", fern_mesh, {x, top, z}, turn, size);
      return;
    }
    const vec3 at(x, column.ground.high, z);
    if (cave) {
      if (chance < 0.16f) plant("tall_fern", reed_mesh, at, turn, 0.8f * size);
    } else if (column.top == k_grass) {
      const float grove = static_cast<float>(noise({0.12 * x, 4.0, 0.12 * z}, 197));
      if (chance < 0.035f * smooth_step(0.45f, 0.7f, grove)) {
        plant("tree", tree_mesh, at, turn, size);
      } else if (chance < 0.11f) {
        plant("tuft", tuft_mesh, at, turn, size);
      } else if (chance < 0.11f + 0.08f * grove) {
        plant("fern", fern_mesh, at, turn, 0.8f * size);
      }
    } else if (column.top == k_sand && at.y < -6.0f && chance < 0.10f) {
      plant("fern", fern_mesh, at, turn, size);
    }
  });
}

}  // namespace

static Scene make_hexworld(const BuiltinOptions& options) {
  Scene scene;
  scene.name = "hexworld";
  std::array<int, k_ground_count> ground;
  const Material stone = textured_material(scene, "stone", limestone_texture(256));
  ground[k_grass] = add_material(scene, textured_material(scene, "grass", soil_texture(256), {0.75f, 0.95f, 0.55f}));
  ground[k_soil] = add_material(scene, textured_material(scene, "soil", bark_texture(128), {0.95f, 0.80f, 0.62f}));
  ground[k_rock] = add_material(scene, tinted(stone, "rock", {0.62f, 0.62f, 0.66f}));
  ground[k_sand] = add_material(scene, tinted(stone, "sand", {1.0f, 0.88f, 0.66f}));
  HexWorld world(scene, static_cast<int>(options.at("radius") + 0.5));
  world.add_columns(ground);
  add_plants(scene, world, options.at("detail"));

  scene.lights.push_back(sun_light("sun", vec3(-0.46f, -0.50f, -0.73f), vec3(1.0f, 0.90f, 0.76f), 3.0f));
  const auto camera = [&](const char* name, const vec3& eye, const vec3& target, double fov, float far) {
    scene.cameras.push_back(look_at(name, eye, target, fov));
    scene.cameras.back().far = far;
  };
  camera("default", {4.5f, 14.0f, 23.0f}, {-4.0f, 2.0f, -3.0f}, 55.0, 200.0f);
  camera("cave", {-9.0f, 3.6f, -2.5f}, {-13.5f, 3.4f, -12.0f}, 70.0, 120.0f);
  camera("gorge", {17.2f, 4.5f, 17.0f}, {13.0f, -7.0f, 1.0f}, 65.0, 150.0f);
  const std::vector<CameraPose> walk = {{{-6.0f, 5.5f, 14.0f}, {-11.0f, 3.0f, -2.0f}},
                                        {{-9.5f, 4.8f, 8.0f}, {-11.5f, 3.2f, -5.0f}},
                                        {{-10.5f, 4.0f, 2.0f}, {-12.0f, 3.4f, -9.0f}},
                                        {{-10.0f, 3.7f, -3.0f}, {-13.5f, 3.4f, -12.0f}}};
  const std::vector<CameraPose> fly = {{{4.5f, 14.0f, 23.0f}, {-6.0f, 2.0f, -4.0f}},
                                       {{18.0f, 16.0f, 14.0f}, {-6.0f, 2.0f, -4.0f}},
                                       {{20.0f, 18.0f, -14.0f}, {-6.0f, 2.0f, -4.0f}},
                                       {{-8.0f, 22.0f, -30.0f}, {-6.0f, 2.0f, -4.0f}},
                                       {{-30.0f, 18.0f, -8.0f}, {-6.0f, 2.0f, -4.0f}}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_hexworld() {
  return {"hexworld",
          "Hexagonal columns with plants, a gorge, and a cave on whose walls the shadows of plants and rock overlap.",
          {{"radius", 60, 8, 120, "Rings of columns around the middle"},
           {"detail", 1.0, 0.05, 4.0, "Leaves as a fraction of those of the full world"}},
          make_hexworld};
}

}  // namespace gnomon
