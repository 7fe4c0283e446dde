// Plants of the built-in scenes: trunks are tubes, leaves are alpha-tested cards with one twig each.
#pragma once

#include <vector>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/shapes.h"

namespace gnomon {

// A square card whose picture's top points along `up` (unit) and whose face is turned by chance around it.
void add_card(MeshPart& part, const vec3& foot, const vec3& up, float size, Random& random);

// Cards that point outward from the middle of an ellipsoid, denser toward its surface.
void add_foliage(MeshPart& part, const vec3& centre, const vec3& radii, int cards, float size, float lift, Random& random);

struct TreeStyle {
  float height = 8.0f, crown = 2.4f;  // of the whole; radius of the crown [m]
  int cards = 240;
  float card = 1.1f;  // side of a card [m]
  int sides = 8;      // of the trunk
  uint32_t seed = 1;
};
// Trunk at the origin, parts {bark, leaves}.
std::vector<MeshPart> make_broadleaf(int bark, int leaves, const TreeStyle& style);
std::vector<MeshPart> make_conifer(int bark, int leaves, const TreeStyle& style);
// A low bush or a tuft without a trunk: part {leaves}.
std::vector<MeshPart> make_bush(int leaves, float radius, float height, int cards, float card, uint32_t seed);

}  // namespace gnomon
