// Houses of the built-in town and landscape: walls with openings, roofs of tiles, chimneys, balconies.
#pragma once

#include <vector>

#include "scene/builtin/parts/shapes.h"

namespace gnomon {

// Indices into Scene::materials.
struct HouseMaterials {
  int wall = 0, trim = 0, roof = 0, brick = 0, wood = 0, glass = 0, iron = 0, cloth = 0;
};

// The front faces +Z; the middle of the front's foot is the origin, and the house reaches to -Z.
struct HouseStyle {
  float width = 12.0f, depth = 10.0f, floor_height = 3.0f, roof_rise = 3.0f;  // metres
  int floors = 2, bays = 4, side_bays = 2;
  int chimneys = 1;
  bool joinery = true;  // sills, glazing bars, shutters
  bool balconies = false, shop = false;
  int tile_rows = 8, tile_columns = 24;  // of one slope; no rows: a smooth roof
  uint32_t seed = 1;
};

// Parts in the order of HouseMaterials; those without triangles are left out.
std::vector<MeshPart> make_house(const HouseMaterials& materials, const HouseStyle& style);

// Convex outline in the XY plane, counter-clockwise seen from +Z, drawn out from z0 to z1 (> z0).
void add_prism(MeshPart& part, const std::vector<vec2>& outline, float z0, float z1, float uv_scale);

}  // namespace gnomon
