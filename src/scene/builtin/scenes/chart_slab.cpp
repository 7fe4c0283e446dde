// chart/slab: a slab over a floor. Its long edge x = 0 throws a straight shadow, whose penumbra is as wide as `gap` makes it.
#include "scene/builtin/parts/chart.h"
#include "scene/builtin/parts/shapes.h"

namespace gnomon {

static Scene make_chart_slab(const BuiltinOptions& options) {
  const auto gap = static_cast<float>(options.at("gap"));
  const vec3 min(-6.0f, gap, -8.0f), max(0.0f, gap + 0.25f, 8.0f);
  Scene scene = chart_with_floor("chart/slab", 20.0f, options);
  MeshPart slab = part_of(1);
  add_box(slab, min, max, 0.5f);
  add_object(scene, "slab", add_mesh(scene, "slab", {slab}));
  const vec3 edge = shadow_on_floor(scene, {0, max.y, 0});
  scene.cameras.push_back(look_at("default", edge + vec3(3.2f, 3.0f + gap, 1.6f), edge + vec3(0.3f, 0, 0), 50.0));
  scene.closed_form = floor_visibility(BoxOccluder{min, max});
  return scene;
}

BuiltinScene builtin_scene_chart_slab() {
  return {"chart/slab", "A slab with a long straight edge over a floor, with the exact visibility of every floor point.",
          with_sun(50, 12, {{"gap", 1.0, 0.01, 5.0, "Height of the slab's underside above the floor [m]"}}), make_chart_slab};
}

}  // namespace gnomon
