// Trunks are tubes; leaves are alpha-tested cards, each with one twig.
#include <cmath>
#include <vector>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/plants.h"
#include "scene/builtin/scenes/courtyard/courtyard_parts.h"

namespace gnomon {
namespace {

struct Branch {
  std::vector<vec3> path;
  std::vector<float> radii;
  vec3 crown;  // radii of its leaves' ellipsoid
  int cards;
};

}  // namespace

void add_olive_tree(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart bark = part_of(materials.bark), leaves = part_of(materials.olive);
  const vec3 fork(0.12f, 1.35f, 0.05f);
  add_tube(bark,
           std::vector<vec3>{
               {0, -0.2f, 0}, {0.02f, 0.12f, 0}, {-0.07f, 0.5f, 0.05f}, {0.04f, 0.95f, 0.0f}, fork, {0.16f, 1.5f, 0.06f}},
           std::vector<float>{0.30f, 0.23f, 0.17f, 0.16f, 0.17f, 0.12f}, 10, 1.5f);
  const std::vector<Branch> branches = {{{fork, {0.55f, 1.85f, 0.25f}, {0.85f, 2.45f, 0.35f}, {1.0f, 3.0f, 0.4f}},
                                         {0.10f, 0.075f, 0.05f, 0.02f},
                                         {0.85f, 0.62f, 0.8f},
                                         90},
                                        {{fork, {-0.35f, 1.8f, -0.2f}, {-0.75f, 2.3f, -0.35f}, {-0.95f, 2.85f, -0.4f}},
                                         {0.10f, 0.07f, 0.05f, 0.02f},
                                         {0.85f, 0.6f, 0.8f},
                                         85},
                                        {{fork, {0.05f, 1.9f, -0.4f}, {0.2f, 2.6f, -0.6f}, {0.25f, 3.3f, -0.6f}},
                                         {0.09f, 0.07f, 0.045f, 0.02f},
                                         {0.85f, 0.65f, 0.75f},
                                         85},
                                        {{fork, {-0.05f, 1.95f, 0.4f}, {-0.2f, 2.5f, 0.7f}, {-0.2f, 3.0f, 0.85f}},
                                         {0.09f, 0.07f, 0.045f, 0.02f},
                                         {0.8f, 0.6f, 0.7f},
                                         80},
                                        {{fork, {0.1f, 2.2f, 0.1f}, {0.0f, 3.0f, 0.1f}, {0.05f, 3.7f, 0.05f}},
                                         {0.09f, 0.07f, 0.05f, 0.02f},
                                         {0.8f, 0.6f, 0.8f},
                                         80}};
  Random random(51);
  for (const Branch& branch : branches) {
    add_tube(bark, branch.path, branch.radii, 6, 1.5f);
    add_foliage(leaves, branch.path.back(), branch.crown, branch.cards, 0.52f, 0.3f, random);
  }
  add_object(scene, "olive_tree", add_mesh(scene, "olive_tree", {bark, leaves}),
             translation({-5.7f, 0, -0.2f}) * rotation({0, 1, 0}, radians_of(20.0)));
}

void add_cypresses(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart bark = part_of(materials.bark), leaves = part_of(materials.cypress);
  add_tube(bark, std::vector<vec3>{{0, -0.2f, 0}, {0, 0.8f, 0}, {0, 4.5f, 0}}, std::vector<float>{0.17f, 0.13f, 0.03f}, 7,
           1.5f);
  Random random(61);
  constexpr int k_cards = 200;
  for (int i = 0; i < k_cards; ++i) {
    const float t = (static_cast<float>(i) + random.unit()) / k_cards;  // up the tree
    const float girth = 0.72f * std::sqrt(std::max(0.0f, (1.0f - t) * (t + 0.12f) * 3.4f)) * 0.55f + 0.05f;
    const vec2 around(unit_circle(2.39996323 * i));
    const vec3 out(around.x, 0, around.y);
    const vec3 foot = vec3(0, 0.35f + 5.5f * t, 0) + out * girth * random.range(0.5f, 0.9f);
    const vec3 up = glm::normalize(vec3(0, 1, 0) + 0.35f * out + 0.15f * random.on_sphere());
    add_card(leaves, foot, up, random.range(0.75f, 1.0f), random);
  }
  const int mesh = add_mesh(scene, "cypress", {bark, leaves});
  add_object(scene, "cypress_west", mesh, translation({-2.2f, 0, -10.2f}));
  add_object(scene, "cypress_east", mesh, translation({3.2f, 0, -9.9f}) * rotation({0, 1, 0}, radians_of(110.0)));
}

void add_potted_shrubs(Scene& scene, const CourtyardMaterials& materials) {
  MeshPart pot = part_of(materials.terracotta), soil = part_of(materials.bark), leaves = part_of(materials.shrub);
  const std::vector<vec2> profile = {{0.0f, 0.0f},   {0.20f, 0.0f},  {0.29f, 0.38f}, {0.33f, 0.38f},
                                     {0.34f, 0.48f}, {0.29f, 0.48f}, {0.27f, 0.40f}};
  add_lathe(pot, profile, 18, {2, 2});
  const std::vector<vec2> surface = {{0.275f, 0.41f}, {0.0f, 0.43f}};
  add_lathe(soil, surface, 18, {1, 1});
  Random random(71);
  add_foliage(leaves, {0, 0.78f, 0}, {0.36f, 0.34f, 0.36f}, 80, 0.34f, 0.4f, random);
  const int mesh = add_mesh(scene, "potted_shrub", {pot, soil, leaves});
  for (const vec2& at : {vec2(4.45f, -1.0f), vec2(6.25f, 3.1f)}) {
    const float y = static_cast<float>(courtyard_ground(at.x, at.y)) - 0.03f;
    add_object(scene, at.y < 0 ? "shrub_north" : "shrub_south", mesh,
               translation({at.x, y, at.y}) * rotation({0, 1, 0}, radians_of(75.0 * at.y)));
  }
}

}  // namespace gnomon
