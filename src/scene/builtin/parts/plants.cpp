// Cards, and trees made of them.
#include "scene/builtin/parts/plants.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

void add_card(MeshPart& part, const vec3& foot, const vec3& up, float size, Random& random) {
  vec3 a, b;
  orthonormal_basis(up, a, b);
  const vec2 turn(unit_circle(6.2831853 * random.unit()));
  const vec3 right = (a * turn.x + b * turn.y) * (0.5f * size), rise = up * size;
  add_quad(part, foot - right, foot + right, foot + right + rise, foot - right + rise, {0, 0}, {1, 1});
}

void add_foliage(MeshPart& part, const vec3& centre, const vec3& radii, int cards, float size, float lift, Random& random) {
  for (int i = 0; i < cards; ++i) {
    const vec3 out = random.on_sphere();
    const vec3 foot = centre + out * radii * random.range(0.35f, 0.85f);
    const vec3 up = glm::normalize(out + vec3(0, lift, 0) + 0.5f * random.on_sphere());
    add_card(part, foot, up, size * random.range(0.75f, 1.2f), random);
  }
}

std::vector<MeshPart> make_broadleaf(int bark_material, int leaf_material, const TreeStyle& style) {
  MeshPart bark = part_of(bark_material), leaves = part_of(leaf_material);
  Random random(style.seed);
  const float h = style.height, r = style.crown, thick = 0.022f * h;
  const float fork = 0.34f * h;
  const float lean_x = random.range(-0.03f, 0.03f), lean_z = random.range(-0.03f, 0.03f);
  const vec3 top(lean_x * h, fork, lean_z * h);
  add_tube(bark, std::vector<vec3>{{0, -0.3f, 0}, {0, 0.05f * h, 0}, 0.5f * top, top, top + vec3(0, 0.25f * h, 0)},
           std::vector<float>{1.7f * thick, 1.15f * thick, 0.9f * thick, 0.8f * thick, 0.3f * thick}, style.sides, 1.0f);
  // The crown is a few balls of leaves around limbs, so that light finds gaps between them.
  constexpr int k_limbs = 5;
  for (int i = 0; i <= k_limbs; ++i) {
    const bool middle = i == k_limbs;
    const vec2 around(unit_circle(6.2831853 * (i + 0.6 * random.unit()) / k_limbs));
    const float reach = middle ? 0.0f : r * random.range(0.5f, 0.65f), rise = h * (middle ? 0.84f : random.range(0.52f, 0.72f));
    const vec3 end(top.x + reach * around.x, rise, top.z + reach * around.y);
    if (!middle) {
      const vec3 bend = glm::mix(top, end, 0.5f) - vec3(0, 0.06f * h, 0);
      add_tube(bark, std::vector<vec3>{top - vec3(0, 0.03f * h, 0), bend, end},
               std::vector<float>{0.55f * thick, 0.4f * thick, 0.12f * thick}, std::max(4, style.sides / 2), 1.0f);
    }
    const vec3 radii = vec3(0.55f * r, 0.16f * h, 0.55f * r) * random.range(0.85f, 1.1f);
    add_foliage(leaves, end, radii, std::max(4, style.cards / (k_limbs + 1)), style.card, 0.35f, random);
  }
  return {bark, leaves};
}

std::vector<MeshPart> make_conifer(int bark_material, int leaf_material, const TreeStyle& style) {
  MeshPart bark = part_of(bark_material), leaves = part_of(leaf_material);
  Random random(style.seed);
  const float h = style.height, thick = 0.018f * h;
  add_tube(bark, std::vector<vec3>{{0, -0.3f, 0}, {0, 0.4f * h, 0}, {0, 0.95f * h, 0}},
           std::vector<float>{1.3f * thick, 0.8f * thick, 0.1f * thick}, style.sides, 1.0f);
  for (int i = 0; i < style.cards; ++i) {
    const float t = (static_cast<float>(i) + random.unit()) / static_cast<float>(style.cards);  // up the tree
    // Whorls of boughs that get shorter upward.
    const float tier = 0.75f + 0.25f * (7.0f * t - std::floor(7.0f * t)),
                girth = style.crown * (1.0f - t) * (1.35f - tier * 0.5f);
    const vec2 around(unit_circle(2.39996323 * i));
    const vec3 out(around.x, 0, around.y);
    const vec3 foot = vec3(0, h * (0.12f + 0.80f * t), 0) + out * girth * random.range(0.25f, 0.6f);
    const vec3 up = glm::normalize(out + vec3(0, -0.35f + 1.3f * t, 0) + 0.2f * random.on_sphere());
    add_card(leaves, foot, up, style.card * (1.15f - 0.6f * t) * random.range(0.8f, 1.15f), random);
  }
  return {bark, leaves};
}

std::vector<MeshPart> make_bush(int leaf_material, float radius, float height, int cards, float card, uint32_t seed) {
  MeshPart leaves = part_of(leaf_material);
  Random random(seed);
  for (int i = 0; i < cards; ++i) {
    const vec2 around(unit_circle(2.39996323 * i));
    const float away = radius * std::sqrt(random.unit());
    const vec3 foot(away * around.x, height * random.range(-0.08f, 0.45f), away * around.y);
    const vec3 up = glm::normalize(vec3(0.7f * around.x * away / radius, 1.0f, 0.7f * around.y * away / radius) +
                                   0.2f * random.on_sphere());
    add_card(leaves, foot, up, card * random.range(0.75f, 1.2f), random);
  }
  return {leaves};
}

}  // namespace gnomon
