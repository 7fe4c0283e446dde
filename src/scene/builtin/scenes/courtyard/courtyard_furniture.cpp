// Iron, wood, pottery and carved stone that stand in the court.
#include <vector>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/scenes/courtyard/courtyard_parts.h"

namespace gnomon {
namespace {

vec3 on_ground(float x, float z) { return {x, static_cast<float>(courtyard_ground(x, z)), z}; }

// A single sheet of the panel texture between two feet, 1.6 m high; u goes on from where the last panel ended.
void add_panel(MeshPart& part, const vec3& from, const vec3& to, float& u) {
  constexpr float k_height = 1.6f;
  const float next = u + glm::length(to - from) / k_height;
  add_quad(part, from, to, to + vec3(0, k_height, 0), from + vec3(0, k_height, 0), {u, 0.0f}, {next, 1.0f});
  u = next;
}

void add_post(MeshPart& part, const vec3& foot, float height) {
  add_box(part, foot + vec3(-0.035f, -0.1f, -0.035f), foot + vec3(0.035f, height, 0.035f), 1.0f);
  add_sphere(part, foot + vec3(0, height + 0.045f, 0), 0.06f, 8, 5, {1, 1});
}

}  // namespace

// Around the olive tree's bed: a low stone kerb, sheets of alpha-tested iron, real posts and a real top rail.
void add_fence(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart kerb = part_of(materials.limestone), panels = part_of(materials.iron_panel), iron = part_of(materials.iron);
  constexpr float k_kerb = 0.22f;
  const std::vector<vec3> corners = {{-7.7f, k_kerb, 2.2f}, {-6.1f, k_kerb, 2.2f}, {-4.5f, k_kerb, 2.2f},
                                     {-2.9f, k_kerb, 2.2f}, {-2.9f, k_kerb, 0.6f}, {-2.9f, k_kerb, -1.0f}};
  add_box(kerb, {-7.85f, -0.3f, 2.05f}, {-2.75f, k_kerb, 2.35f}, 0.7f);
  add_box(kerb, {-3.05f, -0.3f, -1.15f}, {-2.75f, k_kerb, 2.05f}, 0.7f);
  float u = 0.0f;
  for (size_t i = 0; i + 1 < corners.size(); ++i) add_panel(panels, corners[i], corners[i + 1], u);
  for (const vec3& corner : corners) add_post(iron, corner, 1.5f);
  add_object(scene, "fence", add_mesh(scene, "fence", {kerb, panels, iron}));
}

void add_fountain(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart stone = part_of(materials.limestone);
  const std::vector<vec2> basin = {{1.25f, -0.2f}, {1.25f, 0.10f}, {1.12f, 0.14f}, {1.08f, 0.42f}, {1.18f, 0.48f},
                                   {1.20f, 0.56f}, {1.02f, 0.56f}, {0.98f, 0.22f}, {0.0f, 0.20f}};
  add_lathe(stone, basin, 24, {6.0f, 2.0f});
  const std::vector<vec2> stem = {{0.24f, 0.18f}, {0.24f, 0.30f}, {0.13f, 0.38f}, {0.11f, 0.75f}, {0.20f, 0.98f},
                                  {0.48f, 1.10f}, {0.56f, 1.20f}, {0.50f, 1.20f}, {0.10f, 1.12f}, {0.07f, 1.36f},
                                  {0.14f, 1.44f}, {0.14f, 1.52f}, {0.0f, 1.64f}};
  add_lathe(stone, stem, 16, {3.0f, 3.0f});
  add_object(scene, "fountain", add_mesh(scene, "fountain", {stone}), translation({2.3f, 0, 0.6f}));
}

void add_ball(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart stone = part_of(materials.limestone);
  constexpr float k_radius = 0.36f;
  add_sphere(stone, {0, k_radius - 0.004f, 0}, k_radius, 28, 14, {2.0f, 1.0f});
  add_object(scene, "ball", add_mesh(scene, "ball", {stone}), translation(on_ground(0.75f, 6.0f)));
}

// The plank leans on the crate at thirteen degrees: contact at a shallow angle.
void add_crate_and_plank(Scene& scene, const CourtyardMaterials& materials) {
  constexpr float k_half = 0.26f, k_height = 0.5f, k_length = 2.3f, k_board = 0.035f;
  MeshPart crate = part_of(materials.wood);
  add_box(crate, {-k_half + 0.02f, 0.0f, -k_half + 0.02f}, {k_half - 0.02f, k_height - 0.02f, k_half - 0.02f}, 1.2f);
  for (const float s : {-1.0f, 1.0f}) {
    for (const float y : {0.0f, 0.19f, 0.38f}) {  // boards on four sides
      add_box(crate, {-k_half, y, s * k_half - 0.02f}, {k_half, y + 0.12f, s * k_half + 0.02f}, 1.3f);
      add_box(crate, {s * k_half - 0.02f, y, -k_half + 0.02f}, {s * k_half + 0.02f, y + 0.12f, k_half - 0.02f}, 1.3f);
    }
  }
  const mat4 turn = rotation({0, 1, 0}, radians_of(24.0));
  const vec3 crate_foot = on_ground(1.3f, 3.9f) - vec3(0, 0.02f, 0);
  add_object(scene, "crate", add_mesh(scene, "crate", {crate}), translation(crate_foot) * turn);
  MeshPart plank = part_of(materials.wood);
  add_box(plank, {0.0f, 0.0f, -0.13f}, {k_length, k_board, 0.13f}, 0.9f);
  // From the ground in the east up to the crate's rim and a little beyond.
  const vec3 foot = on_ground(3.25f, 4.75f);
  const vec3 rim =
      crate_foot + vec3(0, k_height, 0) + 0.28f * glm::normalize(vec3(foot.x - crate_foot.x, 0, foot.z - crate_foot.z));
  const vec3 along = glm::normalize(rim - foot), side = glm::normalize(glm::cross(along, vec3(0, 1, 0)));
  const mat4 lean(vec4(along, 0), vec4(glm::cross(side, along), 0), vec4(side, 0), vec4(foot, 1));
  add_object(scene, "plank", add_mesh(scene, "plank", {plank}), lean);
}

// Hangs in the middle arch: nothing joins its shadow to anything.
void add_lantern(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart iron = part_of(materials.iron), glass = part_of(materials.glass);
  const auto ring_of = [&](float radius, float height, float thickness) {
    const double r = radius, t = thickness;
    add_surface(iron, {16, 5, true, true, {1, 1}}, [=](double u, double v) {
      const glm::dvec2 around = unit_circle(6.283185307179586 * u), tube = unit_circle(6.283185307179586 * v);
      return glm::dvec3((r + t * tube.x) * around.x, height + t * tube.y, -(r + t * tube.x) * around.y);
    });
  };
  ring_of(0.24f, -0.98f, 0.016f);
  ring_of(0.24f, -0.56f, 0.016f);
  for (int i = 0; i < 6; ++i) {
    const vec2 at = 0.24f * vec2(unit_circle(radians_of(60.0 * i)));
    add_box(iron, {at.x - 0.009f, -0.99f, at.y - 0.009f}, {at.x + 0.009f, -0.55f, at.y + 0.009f}, 1.0f);
  }
  const std::vector<vec2> cap = {{0.0f, -0.56f},  {0.27f, -0.56f},  {0.10f, -0.42f},
                                 {0.03f, -0.36f}, {0.012f, -0.34f}, {0.012f, 0.0f}};
  add_lathe(iron, cap, 12, {1, 1});
  const std::vector<vec2> candle = {{0.0f, -1.0f}, {0.14f, -0.96f}, {0.17f, -0.76f}, {0.14f, -0.6f}, {0.0f, -0.57f}};
  add_lathe(glass, candle, 12, {1, 1});
  add_object(scene, "lantern", add_mesh(scene, "lantern", {iron, glass}), translation({-1.1f, 3.62f, -5.0f}));
}

void add_amphora(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart clay = part_of(materials.terracotta);
  const std::vector<vec2> profile = {{0.0f, 0.0f},   {0.15f, 0.0f},  {0.17f, 0.05f}, {0.29f, 0.32f},  {0.32f, 0.52f},
                                     {0.26f, 0.74f}, {0.13f, 0.88f}, {0.11f, 0.98f}, {0.165f, 1.06f}, {0.165f, 1.09f},
                                     {0.11f, 1.09f}, {0.08f, 0.95f}, {0.0f, 0.6f}};
  add_lathe(clay, profile, 20, {2, 2});
  for (const float side : {-1.0f, 1.0f}) {
    const std::vector<vec3> handle = {
        {side * 0.10f, 0.98f, 0}, {side * 0.25f, 1.02f, 0}, {side * 0.31f, 0.90f, 0}, {side * 0.25f, 0.72f, 0}};
    add_tube(clay, handle, std::vector<float>(handle.size(), 0.022f), 6, 1.0f);
  }
  add_object(scene, "amphora", add_mesh(scene, "amphora", {clay}),
             translation(on_ground(5.6f, -1.55f) - vec3(0, 0.03f, 0)) * rotation({0, 1, 0}, radians_of(40.0)));
}

}  // namespace gnomon
