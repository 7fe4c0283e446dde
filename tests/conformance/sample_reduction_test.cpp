// sample_distribution's reduction over the picture: nearest, farthest and the box of each split, where every thread that meets
// one of the few samples that decide meets many others too.
#include <array>

#include "shadow/explainer.h"
#include "shadow/map/light_views.h"
#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

MeshPart upright(const vec2& low, const vec2& high, float z) {
  MeshPart part = part_of(0);
  add_quad(part, {low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z}, {0, 0}, {1, 1});
  return part;
}

// A wall over most of the picture; a few pixels of a plate before it, and of one behind it, above its top. A thread's eight
// samples lie in one column, four rows apart.
Scene plates_and_wall() {
  Scene scene = test::scene_with({upright({-9, -7}, {9, 3.5f}, -10.0f), upright({0.2f, -0.3f}, {0.6f, 0.1f}, -3.0f),
                                  upright({-8, 12.5f}, {-3, 15}, -30.0f)});
  scene.cameras.push_back(look_at("at the wall", {0, 0, 0}, {0, 0, -1}, 60.0));
  scene.lights.push_back(test::make_sun({0.3f, -0.5f, -1}));
  return scene;
}

TEST(SampleReduction, FewSamplesAmongManyDecide) {
  View view(plates_and_wall(), {64, 48});
  const auto& spec = find_technique("sample_distribution/hard");
  constexpr float k_size = 64.0f, k_border = 4.0f;
  const auto technique = spec.make(
      view.context(),
      test::settings_of(spec, {"sample_distribution.size=64", "sample_distribution.border=4", "sample_distribution.count=3"}));
  Explainer explainer(test::device());
  test::run_passes([&](Recorder& recorder) {
    view.frame().record_surface(recorder);
    technique->record(recorder, view.frame(), 0);
    explainer.record_views(recorder, *technique);
  });
  const auto views = explainer.views();
  ASSERT_EQ(views.size(), 3u);
  EXPECT_NEAR(views[0].interval_m.x, 3.0f, 1e-3f);
  EXPECT_NEAR(views[2].interval_m.y, 30.0f, 1e-2f);

  // Mips are read as wide as pixels are: two more texels of those.
  constexpr float k_expected = k_border + 2.0f * k_size / 48.0f;
  const auto points = view.frame().read_points();
  for (size_t split = 0; split < 3; ++split) {
    const float z = std::array{-3.0f, -10.0f, -30.0f}[split];
    std::array<float, 4> to_edge;  // of the map, from its nearest sample [texel]
    to_edge.fill(1e9f);
    size_t samples = 0;
    for (const SurfacePoint& point : points) {
      if (point.object == k_no_object || std::abs(point.position_ws.z - z) > 0.1f) continue;
      const vec2 clip(light_clip(views[split].raster, point.position_ws));
      for (size_t side = 0; side < 4; ++side) {
        const float place = side % 2 ? -clip[static_cast<int>(side / 2)] : clip[static_cast<int>(side / 2)];
        to_edge[side] = std::min(to_edge[side], 0.5f * k_size * (1.0f - place));
      }
      ++samples;
    }
    EXPECT_GT(samples, 10u) << split;
    for (const float texels : to_edge)
      EXPECT_NEAR(texels, k_expected, 0.05f) << "split " << split << ", " << samples << " samples";
  }
}

}  // namespace
}  // namespace gnomon
