// Overlays and picks against what the techniques' views and masks say.
#include <cmath>
#include <map>
#include <set>

#include "lab/explain/point_reference.h"
#include "lab/explain/reason.h"
#include "shadow/explainer.h"
#include "shadow/registry.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

constexpr uvec2 k_size = {64, 48};

Light lamp_or_sun(const ProjectionInfo& projection) {
  const bool sun = std::find(projection.light_kinds.begin(), projection.light_kinds.end(), LightKind::directional) !=
                   projection.light_kinds.end();
  if (sun) return test::make_sun({0.5f, -1.0f, 0.4f}, 0.01f);
  Light lamp;
  lamp.name = "lamp";
  lamp.kind = LightKind::point;
  lamp.position = {0.5f, 4.0f, 1.0f};
  lamp.radius = 0.05f;
  lamp.intensity = 50.0f;
  return lamp;
}

// A floor with a box, one that casts nothing, and a slab near the floor; and sky above.
Scene boxes(const Light& light) {
  Scene scene = test::scene_with({test::floor_part(20.0f), test::box_part({-1, 0, -1}, {0, 2, 0}),
                                  test::box_part({1, 0.5f, -3}, {2, 1.5f, -2}), test::box_part({-3, 0.3f, 0}, {-1, 0.35f, 2})});
  scene.objects[2].casts = false;
  scene.cameras.push_back(look_at("any", {0, 3, 7}, {0, 1.5f, 0}, 60.0));
  scene.lights.push_back(light);
  return scene;
}

// A technique whose mask and map are those of a drawn frame.
struct Drawn {
  Drawn(View& view, const std::string& name, std::initializer_list<std::string_view> assignments = {})
      : frame(view.frame()), explainer(device()) {
    const TechniqueSpec& spec = find_technique(name);
    technique = spec.make(view.context(), test::settings_of(spec, assignments));
    test::run_passes([&](Recorder& recorder) {
      frame.record_surface(recorder);
      technique->record(recorder, frame, 0);
      frame.record_shade(recorder);
      explainer.record_views(recorder, *technique);
    });
    views = explainer.views();
  }
  PickRecord pick(const uvec2& pixel) {
    test::run_passes([&](Recorder& recorder) { explainer.record_pick(recorder, frame, 0, *technique, pixel); });
    return explainer.picked();
  }
  Image8 with_overlay(uint32_t overlay, float opacity) {
    test::run_passes([&](Recorder& recorder) {
      frame.record_surface(recorder);
      frame.record_shade(recorder);
      explainer.record_overlay(recorder, frame, 0, *technique, overlay, opacity);
    });
    return frame.read_display();
  }
  Frame& frame;
  Explainer explainer;
  std::unique_ptr<Technique> technique;
  std::vector<ShadowView> views;
};

std::vector<uvec2> spread_pixels() {
  std::vector<uvec2> pixels;
  for (uint32_t y = 2; y < k_size.y; y += 5) {
    for (uint32_t x = 3; x < k_size.x; x += 5) pixels.emplace_back(x, y);
  }
  return pixels;
}

template <class Action>
void for_each_projection(const Action& action) {
  for (const ProjectionInfo& projection : projections()) {
    SCOPED_TRACE(projection.id);
    View view(boxes(lamp_or_sun(projection)), k_size);
    action(view, projection.id + "/");
  }
}

TEST(Explain, PicksAgreeWithTheViews) {
  for_each_projection([](View& view, const std::string& projection) {
    Drawn drawn(view, projection + "pcf", {"bias.constant=0"});
    ASSERT_FALSE(drawn.views.empty());
    const auto points = view.frame().read_points();
    size_t layers = 0;
    for (const uvec2& pixel : spread_pixels()) {
      const PickRecord record = drawn.pick(pixel);
      const SurfacePoint& point = points[pixel.y * k_size.x + pixel.x];
      ASSERT_EQ(record.seen != 0, point.object != k_no_object);
      if (!record.seen) continue;
      EXPECT_EQ(record.object, point.object);
      EXPECT_LT(glm::distance(record.position_ws, point.position_ws), 1e-4f);
      EXPECT_FLOAT_EQ(record.radius, 2.0f);  // of pcf's defaults: three texels and a bilinear half on each side
      float weights = 0.0f;
      for (uint32_t i = 0; i < record.count; ++i, ++layers) {
        const PickedLayer& layer = record.layers[i];
        weights += layer.weight;
        ASSERT_LT(layer.layer, drawn.views.size());
        const ShadowView& shadow = drawn.views[layer.layer];
        const vec4 clip = light_clip(shadow.raster, point.position_ws);
        const vec3 ndc = vec3(clip) / clip.w;
        EXPECT_LE(std::max(std::abs(ndc.x), std::abs(ndc.y)), 1.0001f);
        EXPECT_NEAR(layer.uv.x, 0.5f + 0.5f * ndc.x, 2e-6f);
        EXPECT_NEAR(layer.uv.y, 0.5f + 0.5f * ndc.y, 2e-6f);
        EXPECT_NEAR(layer.depth, std::min(ndc.z, 1.0f), 3e-6f);
        EXPECT_NEAR(layer.bias_linear * layer.depth_range_m, 0.0f, 1e-4f);
        EXPECT_EQ(layer.size, shadow.size);
        EXPECT_EQ(layer.texel_x, static_cast<int>(std::floor(layer.uv.x * layer.size)));
        EXPECT_GT(layer.pixels_per_texel, 0.0f);
        EXPECT_GT(layer.texel_m, 0.0f);
        EXPECT_FLOAT_EQ(layer.stored.x, layer.depths[k_pick_texels / 2]);
      }
      EXPECT_NEAR(weights, record.count > 0 ? 1.0f : 0.0f, 1e-5f);
    }
    EXPECT_GT(layers, 10u);
  });
}

// The stored depths of the record, compared with its receiver as the filter does, give the mask.
TEST(Explain, PicksRepeatTheMask) {
  for_each_projection([](View& view, const std::string& projection) {
    Drawn drawn(view, projection + "hard", {"bias.constant=0.7", "bias.slope=0.1", "bias.normal_offset=0.4"});
    int shadowed = 0, lit = 0;
    for (const uvec2& pixel : spread_pixels()) {
      const PickRecord record = drawn.pick(pixel);
      if (!record.seen || !record.receives || record.count == 0) continue;
      float answer = 0.0f;
      for (uint32_t i = 0; i < record.count; ++i) {
        const PickedLayer& layer = record.layers[i];
        const KernelContent content = kernel_content(layer, record.radius);
        EXPECT_GT(content.bias_m, 0.0f);
        const vec2 centre = (vec2(layer.texel_x, layer.texel_y) + 0.5f) / layer.size;
        const float move = glm::clamp(glm::dot(layer.depth_gradient, centre - layer.uv), -layer.plane_move, layer.plane_move);
        answer += layer.depths[k_pick_texels / 2] >= std::min(layer.depth + move, 1.0f) ? layer.weight : 0.0f;
      }
      EXPECT_NEAR(answer, record.answer, 1e-5f) << pixel.x << ", " << pixel.y;
      record.answer > 0.5f ? ++lit : ++shadowed;
    }
    EXPECT_GT(lit, 5);
    EXPECT_GT(shadowed, 0);
  });
}

TEST(Explain, OverlaysChangeSurfacesOnly) {
  for_each_projection([](View& view, const std::string& projection) {
    Drawn drawn(view, projection + "pcf");
    const Image8 plain = view.frame().read_display();
    const auto points = view.frame().read_points();
    for (uint32_t overlay = k_overlay_none + 1; overlay < k_overlay_count; ++overlay) {
      SCOPED_TRACE(overlay_name(overlay));
      const Image8 shown = drawn.with_overlay(overlay, 0.5f);
      size_t changed = 0;
      for (size_t i = 0; i < points.size(); ++i) {
        const bool same = std::equal(&plain.rgba[4 * i], &plain.rgba[4 * i + 4], &shown.rgba[4 * i]);
        EXPECT_TRUE(same || points[i].object != k_no_object) << i;
        changed += !same;
      }
      EXPECT_GT(changed, 100u);
    }
  });
}

TEST(Explain, MaskAndPickWithSeveralSamples) {
  View view(boxes(test::make_sun({0.5f, -1.0f, 0.4f})), k_size, device().info().sample_counts.back());
  Drawn drawn(view, "cascaded/vsm", {"vsm.samples=four"});
  const uint32_t samples = view.frame().samples();
  const auto mask = view.frame().read_mask(0);
  for (const uvec2& pixel : spread_pixels()) {
    const PickRecord record = drawn.pick(pixel);
    if (!record.seen) continue;
    EXPECT_EQ(record.answer, mask[(pixel.y * k_size.x + pixel.x) * samples]);
  }
  drawn.with_overlay(k_overlay_layers, 0.5f);
}

TEST(Explain, FlagsNameCastersAndReceivers) {
  View view(boxes(test::make_sun({0.5f, -1.0f, 0.4f})), k_size);
  Drawn drawn(view, "single/hard");
  const Image8 shown = drawn.with_overlay(k_overlay_flags, 1.0f);
  const auto points = view.frame().read_points();
  std::set<uint32_t> seen;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].object == k_no_object) continue;
    const bool faces = glm::dot(points[i].geometric_normal_ws, view.scene().lights[0].direction) < -k_grazing_cosine;
    const uint32_t flag = !faces ? k_flag_away : points[i].object == 2 ? k_flag_receiver : k_flag_caster;
    seen.insert(flag);
    const vec3 colour = flag_colour(flag) * 255.0f;
    for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(shown.rgba[4 * i + channel], colour[channel], 1.0f) << i;
  }
  EXPECT_EQ(seen.size(), 3u);
}

// Planes one above the other, seen from above, in the order of drawing.
void expect_overdraw(const std::vector<float>& heights, float count) {
  std::vector<MeshPart> parts;
  for (const float height : heights) parts.push_back(test::floor_part(10.0f, height));
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("down", {0, 10, 0.01f}, {0, 0, 0}, 40.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  View view(std::move(scene), {16, 16});
  Drawn drawn(view, "single/hard");
  const Image8 shown = drawn.with_overlay(k_overlay_overdraw, 1.0f);
  const vec3 expected = ramp_colour(overdraw_place(count)) * 255.0f;
  const uint8_t* middle = shown.at(8, 8);
  EXPECT_NEAR(middle[0], expected.x, 1.0f);
  EXPECT_NEAR(middle[1], expected.y, 1.0f);
  EXPECT_NEAR(middle[2], expected.z, 1.0f);
}

TEST(Explain, OverdrawOfAStackOfPlanes) {
  expect_overdraw({0, 1, 2, 3, 4}, 5.0f);  // each hides what was drawn before
  expect_overdraw({4, 3, 2, 1, 0}, 1.0f);  // the first hides all others
  expect_overdraw({2, 4, 0, 5}, 3.0f);
}

// How often each cause is named, over the pixels of a picture.
std::map<Cause, int> causes(View& view, const std::string& name, std::initializer_list<std::string_view> assignments) {
  Drawn drawn(view, name, assignments);
  SharedReference rays(view.scene());
  PointReference reference(rays);
  std::map<Cause, int> counts;
  for (uint32_t y = 1; y < k_size.y; y += 3) {
    for (uint32_t x = 1; x < k_size.x; x += 3) {
      PickFacts facts;
      facts.record = drawn.pick({x, y});
      facts.has_map = true;
      facts.compares_depth = drawn.technique->shadow_map()->filtered == drawn.technique->shadow_map()->depth;
      if (facts.record.seen) {
        const SurfacePoint point = {facts.record.position_ws, facts.record.object, facts.record.normal_ws, y * k_size.x + x};
        std::optional<PointReference::Answer> right;
        while (!right) right = reference.answer(point, view.frame().camera().eye_ws, view.scene().lights[0]);
        facts.hard = right->hard, facts.area = right->area;
      }
      ++counts[reason_of(facts).cause];
    }
  }
  return counts;
}

TEST(Explain, ReasonsFitTheSettingsThatCauseThem) {
  View view(boxes(test::make_sun({0.5f, -1.0f, 0.4f}, 0.01f)), k_size);
  auto good = causes(view, "single/hard", {"single.size=2048"});
  EXPECT_GT(good[Cause::none], 150);
  EXPECT_GT(good[Cause::no_receiver], 10);
  EXPECT_GT(good[Cause::sky], 10);
  EXPECT_LT(good[Cause::acne] + good[Cause::peter_panning] + good[Cause::unknown], 3);
  auto acne = causes(view, "single/hard", {"single.size=512", "bias.receiver_plane=false", "bias.constant=0"});
  EXPECT_GT(acne[Cause::acne], 30);
  EXPECT_GT(acne[Cause::acne], 10 * (acne[Cause::resolution] + acne[Cause::unknown]));
  auto detached = causes(view, "single/hard", {"single.size=2048", "bias.unit=centimetre", "bias.constant=70"});
  EXPECT_GT(detached[Cause::peter_panning], 5);
  EXPECT_EQ(detached[Cause::acne], 0);
  auto blurred = causes(view, "single/pcf", {"single.size=256", "pcf.size=9"});
  EXPECT_GT(blurred[Cause::filter_width], 5);
  EXPECT_EQ(blurred[Cause::acne] + blurred[Cause::light_bleeding] + blurred[Cause::unknown], 0);
}

// Two casters above one receiver: near the edge of the higher one the depths differ most.
TEST(Explain, LightBleedingIsCalledSo) {
  Scene scene = test::scene_with(
      {test::floor_part(10.0f), test::box_part({-3, 1, -3}, {3, 1.2f, 3}), test::box_part({-0.5f, 8, -3}, {0.5f, 8.2f, 3})});
  scene.cameras.push_back(look_at("below", {0, 0.8f, 6}, {0, 0, 0}, 50.0));
  scene.lights.push_back(test::make_sun({0, -1, 0.01f}, 0.001f));
  View view(std::move(scene), k_size);
  auto counts = causes(view, "single/vsm", {"single.size=256", "vsm.blur=3", "vsm.bleeding=0"});
  EXPECT_GT(counts[Cause::light_bleeding], 5);
  EXPECT_EQ(counts[Cause::unknown], 0);
}

TEST(Explain, DirectTechniquesHaveNoMap) {
  if (!device().info().ray_tracing) GTEST_SKIP() << "no ray-tracing pipeline: no direct technique";
  View view(boxes(test::make_sun({0.5f, -1.0f, 0.4f})), k_size);
  Drawn drawn(view, "ray_traced");
  EXPECT_TRUE(drawn.views.empty());
  EXPECT_FALSE(drawn.technique->shadow_map());
  const Image8 plain = view.frame().read_display();
  EXPECT_EQ(drawn.with_overlay(k_overlay_layers, 0.5f).rgba, plain.rgba);
  EXPECT_NE(drawn.with_overlay(k_overlay_flags, 0.5f).rgba, plain.rgba);
  const PickRecord record = drawn.pick({32, 40});
  EXPECT_EQ(record.seen, 1u);
  EXPECT_EQ(record.count, 0u);
}

}  // namespace
}  // namespace gnomon
