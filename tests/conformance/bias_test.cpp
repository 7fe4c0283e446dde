// Biases in closed form: how far each moves a receiver toward a sun, in metres, as picks tell it.
#include <cmath>
#include <set>

#include "shadow/explainer.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

constexpr float k_degree = k_pi / 180.0f;

// A floor that reaches far, so that several cascades are asked, and a box over it.
View& floor_under(float from_vertical_deg) {
  return test::kept_view(fmt::format("bias, sun {} degrees from the vertical", from_vertical_deg),
                         [=] {
                           Scene scene = test::scene_with({test::floor_part(60.0f), test::box_part({-1, 1, -3}, {1, 2, -1})});
                           scene.cameras.push_back(look_at("level", {0, 2, 6}, {0, 0, -6}, 60.0));
                           const float angle = from_vertical_deg * k_degree;
                           scene.lights.push_back(test::make_sun({std::sin(angle), -std::cos(angle), 0}));
                           return scene;
                         },
                         {48, 36});
}

// Expects that each picked layer of the floor was moved toward the light by `metres`, which it is told.
template <class Metres>
std::set<uint32_t> expect_moved(View& view, const std::string& technique, std::initializer_list<std::string_view> settings,
                                const Metres& metres) {
  const auto& spec = find_technique(technique);
  const auto made = spec.make(view.context(), test::settings_of(spec, settings));
  Explainer explainer(test::device());
  std::set<uint32_t> layers;
  for (const uvec2 pixel : {uvec2(5, 34), uvec2(40, 30), uvec2(22, 24), uvec2(3, 18), uvec2(45, 14), uvec2(24, 11)}) {
    test::run_passes([&](Recorder& recorder) {
      view.frame().record_surface(recorder);
      made->record(recorder, view.frame(), 0);
      explainer.record_pick(recorder, view.frame(), 0, *made, pixel);
    });
    const PickRecord record = explainer.picked();
    if (!record.seen || record.object != 0) continue;
    for (uint32_t i = 0; i < record.count; ++i) {
      const PickedLayer& layer = record.layers[i];
      const float expected = metres(layer, record.radius), found = layer.bias_linear * layer.depth_range_m;
      EXPECT_NEAR(found, expected, 0.01f * expected + 2e-6f * layer.depth_range_m) << pixel.x << ", " << pixel.y;
      layers.insert(layer.layer);
    }
  }
  EXPECT_FALSE(layers.empty()) << technique;
  return layers;
}

TEST(Bias, EachMovesTheReceiverByItsFormula) {
  for (const float angle : {20.0f, 75.0f}) {
    View& view = floor_under(angle);
    const float tangent = std::tan(angle * k_degree);
    const auto moved = [&](std::initializer_list<std::string_view> settings, float texels) {
      SCOPED_TRACE(fmt::format("{} degrees, {}", angle, *std::prev(settings.end())));
      expect_moved(view, "single/pcf", settings, [=](const PickedLayer& layer, float) { return texels * layer.texel_m; });
    };
    moved({"single.size=256", "bias.constant=3"}, 3.0f);
    moved({"single.size=256", "bias.constant=0", "bias.slope=2"}, 2.0f * tangent);
    moved({"single.size=256", "bias.constant=0", "bias.slope=2", "bias.max_slope=1.5"}, 2.0f * std::min(tangent, 1.5f));
    // Along the normal by the sine; seen along the light that is one over the cosine as much.
    moved({"single.size=256", "bias.constant=0", "bias.normal_offset=2"}, 2.0f * tangent);
  }
}

TEST(Bias, UnitsAndGrowthScaleAllOfIt) {
  View& view = floor_under(50.0f);
  expect_moved(view, "single/pcf", {"bias.unit=centimetre", "bias.constant=30"},
               [](const PickedLayer&, float) { return 0.3f; });
  expect_moved(view, "single/pcf", {"single.size=256", "bias.constant=1", "bias.filter_growth=0.5"},
               [](const PickedLayer& layer, float radius) { return (1.0f + 0.5f * radius) * layer.texel_m; });
  const auto layers = expect_moved(
      view, "cascaded/pcf", {"cascaded.size=256", "cascaded.adapt=false", "bias.constant=2", "bias.layer_growth=1.7"},
      [](const PickedLayer& layer, float) { return 2.0f * std::pow(1.7f, float(layer.layer)) * layer.texel_m; });
  EXPECT_GE(layers.size(), 2u) << "several cascades must be asked";
}

TEST(Bias, MomentsAreComparedNearerToTheLight) {
  View& view = floor_under(20.0f);
  const auto& spec = find_technique("single/msm");
  const auto light = [&](std::string_view bias) {
    double sum = 0.0;
    for (const float v : test::run_technique(view, spec, test::settings_of(spec, {"single.size=256", bias})).mask) sum += v;
    return sum;
  };
  EXPECT_GT(light("msm.depth_bias=50"), 1.001 * light("msm.depth_bias=0"));
}

}  // namespace
}  // namespace gnomon
