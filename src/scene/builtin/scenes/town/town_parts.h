// What the town is put together from. Streets run along Z; the main one lies around x = 0 and the viewer looks to -Z.
#pragma once

#include <vector>

#include "scene/builtin/parts/house.h"

namespace gnomon {

struct TownMaterials {
  std::vector<HouseMaterials> houses;  // one for each tint of plaster
  int asphalt, pavement, kerb, grass, bark, leaves, needles, shrub, iron, wood, glass, stone, masonry, roof, lamp, paint;
  std::vector<int> cars;
};
TownMaterials add_town_materials(Scene& scene);

// Street furniture and the like: parts of one mesh, foot at the origin. `detail` scales what is round or leafy.
std::vector<MeshPart> make_lamp_post(const TownMaterials& m, double detail);
std::vector<MeshPart> make_bench(const TownMaterials& m);
std::vector<MeshPart> make_car(const TownMaterials& m, int paint, bool van, double detail);    // front at +X
std::vector<MeshPart> make_picket_fence(const TownMaterials& m, float length, double detail);  // along X from the origin
std::vector<MeshPart> make_planter(const TownMaterials& m, double detail);
std::vector<MeshPart> make_tower(const TownMaterials& m, double detail);  // 58 m, with a belfry
std::vector<MeshPart> make_crane(const TownMaterials& m, double detail);  // lattice; its jib along +X
std::vector<MeshPart> make_water_tower(const TownMaterials& m, double detail);

}  // namespace gnomon
