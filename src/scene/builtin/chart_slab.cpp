// chart/slab: a slab over a floor. Its long edge x = 0 throws a straight shadow, whose penumbra is as wide as `gap` makes it.
#include "scene/builtin/chart.h"
#include "scene/builtin/shapes.h"

namespace gnomon {

Scene make_chart_slab(const BuiltinOptions& options) {
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

}  // namespace gnomon
