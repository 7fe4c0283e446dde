// chart/sphere: a sphere over a floor, fine enough that its silhouette is a circle at any picture size.
#include "scene/builtin/parts/chart.h"
#include "scene/builtin/parts/shapes.h"

namespace gnomon {

static Scene make_chart_sphere(const BuiltinOptions& options) {
  const double radius = options.at("radius"), height = options.at("height");
  const auto r = static_cast<float>(radius), h = static_cast<float>(height);
  Scene scene = chart_with_floor("chart/sphere", 20.0f, options);
  MeshPart sphere = part_of(1);
  const vec3 centre(0.0f, r + h, 0.0f);
  add_sphere(sphere, centre, r, 512, 256, {2.0f, 1.0f});  // sagitta of a chord: 2e-5 of the radius
  add_object(scene, "sphere", add_mesh(scene, "sphere", {sphere}));
  const vec3 shadow = shadow_on_floor(scene, centre);
  const float away = 1.2f + 2.2f * r + 0.5f * h;
  scene.cameras.push_back(look_at("default", shadow + away * vec3(0.5f, 1.1f, 0.9f), shadow, 45.0));
  scene.closed_form = floor_visibility(SphereOccluder{centre, r});
  return scene;
}

BuiltinScene builtin_scene_chart_sphere() {
  return {"chart/sphere", "A sphere over a floor, with the exact visibility of every floor point.",
          with_sun(50, 12,
                   {{"radius", 0.5, 0.05, 3.0, "Radius of the sphere [m]"},
                    {"height", 0.5, 0.0, 5.0, "Height of its lowest point above the floor [m]"}}),
          make_chart_sphere};
}

}  // namespace gnomon
