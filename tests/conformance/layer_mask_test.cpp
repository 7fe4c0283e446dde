// Masks against rays where every layer of a map has casters and receivers of its own: a layer that is filled, turned or read as
// another one shows in its own region.
#include <cmath>

#include "shadow/explainer.h"
#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

struct Share {
  size_t receivers = 0, dark = 0, wrong = 0;
  double of(size_t n) const { return static_cast<double>(n) / static_cast<double>(std::max<size_t>(receivers, 1)); }
  void add(float answer, float truth) {
    ++receivers;
    dark += truth < 0.5f, wrong += answer != truth;
  }
};

ReferenceResult rays(View& view) {
  view.draw();
  return EmbreeReference(view.scene())
      .trace(view.frame().read_points(), view.frame().camera().eye_ws, view.scene().lights[0], false, 1, 1);
}

std::vector<float> mask_of(View& view, Technique& technique, Explainer* explainer = nullptr) {
  test::run_passes([&](Recorder& recorder) {
    view.frame().record_surface(recorder);
    technique.record(recorder, view.frame(), 0);
    if (explainer) explainer->record_views(recorder, technique);
  });
  return view.frame().read_mask(0);
}

const vec3 k_lamp(0.1f, 0.15f, -0.1f);

vec3 toward(int side) {
  vec3 axis(0.0f);
  axis[side / 2] = side % 2 ? -1.0f : 1.0f;
  return axis;
}

// A room around a lamp. Before each wall hang two boxes as before no other, in no place that a turn or a mirror maps to
// another.
Scene room_of_six_patterns() {
  std::vector<MeshPart> parts = {test::box_part(vec3(-2), vec3(2))};
  for (int side = 0; side < 6; ++side) {
    const float k = static_cast<float>(side);
    for (const vec2 polar : {vec2(0.34f, 0.5f + 1.15f * k), vec2(0.2f, 2.9f + 0.83f * k)}) {
      vec3 at = k_lamp + toward(side);
      at[(side / 2 + 1) % 3] += polar.x * std::cos(polar.y);
      at[(side / 2 + 2) % 3] += polar.x * std::sin(polar.y);
      const vec3 half(0.3f * polar.x + 0.008f * k);
      parts.push_back(test::box_part(at - half, at + half));
    }
  }
  Scene scene = test::scene_with(std::move(parts));
  scene.materials[0].double_sided = true;
  scene.cameras.push_back(look_at("any", k_lamp, k_lamp + vec3(1, 0, 0), 90.0));
  scene.lights.push_back(test::make_light(LightKind::point, {0, -1, 0}, k_lamp, 0.0f));
  return scene;
}

TEST(LayerMask, EveryWallAroundALampHasItsOwnShadows) {
  View view(room_of_six_patterns(), {64, 48});
  const auto &cube = find_technique("cube/hard"), &paraboloid = find_technique("dual_paraboloid/hard");
  const auto faces = cube.make(view.context(), test::settings_of(cube, {"cube.size=256"}));
  const auto halves = paraboloid.make(view.context(), test::settings_of(paraboloid, {"dual_paraboloid.size=512"}));
  for (int side = 0; side < 6; ++side) {
    // From behind the boxes, so that none hides its shadow.
    const vec3 eye = k_lamp + 1.25f * toward(side);
    view.frame().set_camera(look_at("wall", eye, eye + toward(side) + vec3(0.01f, 0.02f, 0.03f), 100.0));
    const ReferenceResult truth = rays(view);
    const auto expect_truth = [&](const std::string& name, Technique& technique) {
      const auto mask = mask_of(view, technique);
      Share share;
      for (size_t i = 0; i < mask.size(); ++i) {
        if (truth.receiver[i]) share.add(mask[i], truth.visibility[i]);
      }
      EXPECT_GT(share.receivers, 2000u) << name << ", side " << side;
      EXPECT_GT(share.of(share.dark), 0.04) << name << ", side " << side;
      EXPECT_LT(share.of(share.wrong), 0.015) << name << ", side " << side;
    };
    expect_truth("cube", *faces);
    for (const std::string_view axis : {"dual_paraboloid.axis=scene", "dual_paraboloid.axis=view"}) {
      halves->set(test::settings_of(paraboloid, {"dual_paraboloid.size=512", axis}));
      expect_truth(std::string(axis), *halves);
    }
  }
}

// Boxes that hover over an open floor, as many and as large in each slice of the view as pixels see them.
Scene long_floor() {
  std::vector<MeshPart> parts = {test::floor_part(90.0f)};
  float distance = 4.0f;
  for (int i = 0; i < 36; ++i, distance *= 1.08f) {
    const vec3 at(distance * 0.8f * std::sin(2.4f * static_cast<float>(i)), 0.09f * distance, -distance);
    const vec3 half = 0.045f * distance * vec3(1.0f + 0.3f * std::sin(static_cast<float>(i)), 0.6f, 1.4f);
    parts.push_back(test::box_part(at - half, at + half));
  }
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("along", {0, 6, 0}, {0, 0, -10.4f}, 60.0));
  scene.cameras[0].near = 5.5f, scene.cameras[0].far = 60.0f;
  scene.lights.push_back(test::make_sun({0.5f, -1, 0.3f}));
  return scene;
}

struct Slicing {
  std::string name;
  std::initializer_list<std::string_view> settings;
};

TEST(LayerMask, EverySliceOfAnOpenViewHasItsOwnShadows) {
  View view(long_floor(), {96, 72});
  const ReferenceResult truth = rays(view);
  const auto depth = test::read_surface<float>(view, "surface view_z");
  Explainer explainer(test::device());
  for (const Slicing& slicing :
       {Slicing{"cascaded/hard",
                {"cascaded.size=512", "cascaded.adapt=false", "cascaded.selection=interval", "cascaded.lambda=1"}},
        Slicing{"cascaded/hard", {"cascaded.size=512", "cascaded.adapt=false", "cascaded.fit=box", "cascaded.lambda=1"}},
        Slicing{"sample_distribution/hard", {"sample_distribution.size=512"}}}) {
    const auto& spec = find_technique(slicing.name);
    const auto technique = spec.make(view.context(), test::settings_of(spec, slicing.settings));
    const auto mask = mask_of(view, *technique, &explainer);
    const auto views = explainer.views();
    ASSERT_EQ(views.size(), 4u);
    const float near = 5.5f, far = views.back().interval_m.y;
    std::array<Share, 4> slices;
    for (size_t i = 0; i < mask.size(); ++i) {
      if (!truth.receiver[i] || depth[i] < near || depth[i] > far) continue;
      // By the rule, not by what the views say.
      const float slice = 4.0f * std::log(depth[i] / near) / std::log(far / near);
      slices[std::min(static_cast<size_t>(std::max(slice, 0.0f)), size_t{3})].add(mask[i], truth.visibility[i]);
    }
    for (size_t i = 0; i < slices.size(); ++i) {
      const Share& share = slices[i];
      fmt::print("{}, slice {}: {} receivers, {:.3f} dark, {:.4f} wrong\n", slicing.name, i, share.receivers,
                 share.of(share.dark), share.of(share.wrong));
      EXPECT_GT(share.receivers, 300u) << i;
      EXPECT_GT(share.of(share.dark), 0.05) << i;
      EXPECT_LT(share.of(share.wrong), 0.015) << i;
    }
  }
}

}  // namespace
}  // namespace gnomon
