// The table of built-in scenes.
#include "scene/builtin/builtin.h"

#include <array>

#include "scene/load.h"

namespace gnomon {
namespace {

std::vector<BuiltinOption> with_sun(double elevation, double azimuth, std::vector<BuiltinOption> options) {
  options.push_back({"elevation", elevation, 5.0, 90.0, "Height of the sun above the horizon [degrees]"});
  options.push_back({"azimuth", azimuth, -180.0, 180.0, "Where the light travels: 0 along +X, 90 along +Z [degrees]"});
  options.push_back({"sun_deg", 0.0, 0.0, 5.0, "Angular diameter of the sun's disc; 0 is a hard light [degrees]"});
  return options;
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() {
  static const std::array<BuiltinScene, 9> scenes = {{
      {"chart/fence", "Alpha-tested bars over a floor, with the exact visibility of every floor point.",
       with_sun(50, 12,
                {{"bars", 12, 1, 64, "Number of bars on four metres"},
                 {"gap", 0.2, 0.0, 5.0, "Height of the bars' lower end above the floor [m]"}}),
       make_chart_fence},
      {"chart/slab", "A slab with a long straight edge over a floor, with the exact visibility of every floor point.",
       with_sun(50, 12, {{"gap", 1.0, 0.01, 5.0, "Height of the slab's underside above the floor [m]"}}), make_chart_slab},
      {"chart/sphere", "A sphere over a floor, with the exact visibility of every floor point.",
       with_sun(50, 12,
                {{"radius", 0.5, 0.05, 3.0, "Radius of the sphere [m]"},
                 {"height", 0.5, 0.0, 5.0, "Height of its lowest point above the floor [m]"}}),
       make_chart_sphere},
      {"courtyard",
       "A Mediterranean courtyard in the late afternoon: columns, iron fence, foliage, stairs and everything else that strains "
       "shadows.",
       {},
       make_courtyard},
      {"hexworld",
       "Hexagonal columns with plants, a gorge, and a cave on whose walls the shadows of plants and rock overlap.",
       {{"radius", 60, 8, 120, "Rings of columns around the middle"}, {"detail", 1.0, 0.05, 4.0, "Leaves as a fraction of those of the full world"}},
       make_hexworld},
      {"lamps", "A closed room with a pendant lamp, a spot lamp behind a grating and the beam of a projector; no sun.", {}, make_lamps},
      {"landscape",
       "Four kilometres of hills with woods and houses under three suns, and the beam of a projector on a hamlet.",
       {{"detail", 1.0, 0.02, 4.0, "Triangles of ground, leaves and roofs as a fraction of those of the full landscape"}},
       make_landscape},
      {"terrain",
       "A height map of 135 x 135 vertices and a sculpture of 1.3 million.",
       {{"detail", 1.0, 0.001, 4.0, "Vertices of the sculpture as a fraction of 1.3 million"}},
       make_terrain},
      {"town",
       "Streets to a far horizon: a thousand objects, most of them instances, and a million triangles; a tower behind the viewer casts "
       "into the view.",
       {{"detail", 1.0, 0.02, 4.0, "Triangles of roofs, leaves and ornaments as a fraction of those of the full town"}},
       make_town},
  }};
  return scenes;
}

}  // namespace gnomon
