// What the courtyard is put together from: its materials, and one function for each kind of thing. Coordinates of the scene:
// the viewer looks north-east (-Z is north), the sun stands in the north-west.
#pragma once

#include "scene/builtin/parts/shapes.h"

namespace gnomon {

// Indices into Scene::materials.
struct CourtyardMaterials {
  int paving, masonry, plaster, limestone, terracotta, wood, bark, iron, iron_panel, olive, cypress, shrub, glass;
};
CourtyardMaterials add_courtyard_materials(Scene& scene);

// Height of the paving.
double courtyard_ground(double x, double z);

// Wall in the plane z = 0 .. -thickness with round-headed openings between supports at x = k * span, k = 0 .. spans; the wall
// reaches half a support's width beyond the outer ones.
struct Arcade {
  int spans = 1;
  float span = 2.0f;       // from centre to centre of the supports [m]
  float opening = 1.6f;    // width [m]
  float bottom = 0.0f;     // of the wall beside the openings; may be `springing` where columns carry the arches [m]
  float springing = 2.0f;  // where arches begin [m]
  float top = 3.5f;
  float thickness = 0.4f;
  int segments = 12;  // of a half circle
};
void add_arcade(MeshPart& part, const Arcade& arcade, float uv_scale);

// Architecture: all stand on y = 0, centred on or beginning at the origin as the comments in the file say.
void add_paving(Scene& scene, const CourtyardMaterials& materials);
void add_colonnade(Scene& scene, const CourtyardMaterials& materials);
void add_gate_wall(Scene& scene, const CourtyardMaterials& materials);
void add_stairs(Scene& scene, const CourtyardMaterials& materials);
void add_tower(Scene& scene, const CourtyardMaterials& materials);
void add_garden_wall(Scene& scene, const CourtyardMaterials& materials);

// Furniture.
void add_fence(Scene& scene, const CourtyardMaterials& materials);
void add_fountain(Scene& scene, const CourtyardMaterials& materials);
void add_ball(Scene& scene, const CourtyardMaterials& materials);
void add_crate_and_plank(Scene& scene, const CourtyardMaterials& materials);
void add_lantern(Scene& scene, const CourtyardMaterials& materials);
void add_amphora(Scene& scene, const CourtyardMaterials& materials);

// Plants.
void add_olive_tree(Scene& scene, const CourtyardMaterials& materials);
void add_cypresses(Scene& scene, const CourtyardMaterials& materials);
void add_potted_shrubs(Scene& scene, const CourtyardMaterials& materials);

}  // namespace gnomon
