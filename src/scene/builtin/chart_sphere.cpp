// chart/sphere: a sphere over a floor, fine enough that its silhouette is a circle at any picture size.
#include "scene/builtin/chart.h"
#include "scene/builtin/shapes.h"

namespace gnomon {

Scene make_chart_sphere(const BuiltinOptions& options) {
  const double radius = options.at("radius"), height = options.at("height");
  const auto r = static_cast<float>(radius), h = static_cast<float>(height);
  Scene scene = chart_with_floor("chart/sphere", 20.0f, options);
  MeshPart sphere = part_of(1);
  const vec3 centre(0.0f, r + h, 0.0f);
  add_sphere(sphere, centre, r, 512, 256, {2.0f, 1.0f});  // sagitta of a chord: 2e-5 of the radius
  add_object(scene, "sphere", add_mesh(scene, "sphere", {sphere}));
  scene.cameras.push_back(look_at("default", {1.5f + 2.2f * r, 3.0f + 3.5f * r + h, 2.5f + 3.0f * r}, {0.6f * r + 0.4f * h, 0.0f, 0.0f}, 45.0));
  scene.closed_form = floor_visibility(SphereOccluder{centre, r});
  return scene;
}

}  // namespace gnomon
