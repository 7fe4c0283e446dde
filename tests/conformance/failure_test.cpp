// Each failure that a technique is known for is visible in a scene and in a number, against rays; and so is what mends it.
// Elsewhere: acne, peter-panning and lost cut-outs (relation_test.cpp), edges that crawl while the viewer moves
// (cascade_test.cpp), objects that do not shadow themselves (percentage_closer_test.cpp), bent triangles of paraboloids
// (projection_test.cpp).
#include <algorithm>
#include <cmath>

#include "measure/visibility_error.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;
using Assignments = std::initializer_list<std::string_view>;

std::vector<float> mask_of(View& view, const std::string& technique, Assignments assignments) {
  const auto& spec = find_technique(technique);
  return test::run_technique(view, spec, test::settings_of(spec, assignments)).mask;
}

VisibilityError error_of(View& view, const std::string& technique, Assignments assignments) {
  const auto mask = mask_of(view, technique, assignments);
  const ReferenceResult& truth = test::hard_reference(view);
  return visibility_error(mask, truth.visibility, truth.receiver);
}

double amount(const OneSidedError& error) { return error.area * error.severity; }

void report(const std::string& name, const VisibilityError& error) {
  fmt::print("{:44}: mae {:.5f}, false shadow {:.5f}, false light {:.5f}\n", name, error.mae, amount(error.false_shadow),
             amount(error.false_light));
}

// --- Light bleeding

// Plants before the rock that shades a cave's wall: two casters of different depths. Where every texel of a wide kernel is
// nearer to the light than the receiver, comparison finds no light at all: what a variance map finds there is bleeding, and no
// soft edge.
TEST(Failure, VarianceMapsBleedWhereShadowsOverlap) {
  View& view = test::kept_view("cave",
                               [] {
                                 Scene scene = load_scene("hexworld", {{"radius", 20.0}, {"detail", 0.3}});
                                 std::erase_if(scene.cameras, [](const Camera& camera) { return camera.name != "cave"; });
                                 return scene;
                               },
                               {192, 128});
  constexpr std::string_view k_size = "single.size=1024";
  const ReferenceResult& truth = test::hard_reference(view);
  const auto compared = mask_of(view, "single/pcf", {k_size, "pcf.size=11"});
  std::vector<uint8_t> dark(compared.size());
  for (size_t i = 0; i < dark.size(); ++i) dark[i] = truth.receiver[i] && truth.visibility[i] == 0.0f && compared[i] == 0.0f;
  ASSERT_GT(test::count(dark), 1000u);
  const auto bled = [&](const std::string& technique, Assignments assignments) {
    const auto error = visibility_error(mask_of(view, technique, assignments), truth.visibility, dark);
    fmt::print("{}, where no texel is lit: {:.2f} % too bright, by {:.4f}\n", technique, 100.0 * error.false_light.area,
               error.false_light.severity);
    return amount(error.false_light);
  };
  const double bleeding = bled("single/vsm", {k_size, "vsm.blur=4", "vsm.bleeding=0"});
  const double reduced = bled("single/vsm", {k_size, "vsm.blur=4", "vsm.bleeding=0.4"});
  const double warped = bled("single/evsm", {k_size, "evsm.blur=4"});
  EXPECT_GT(bleeding, 0.001);
  EXPECT_LT(reduced, 0.1 * bleeding);
  EXPECT_LT(warped, 0.3 * bleeding);
}

// --- Resolution

View& town() {
  return test::kept_view("town", [] { return load_scene("town", {{"detail", 0.02}}); }, {192, 120});
}

TEST(Failure, OneMapIsCoarseNearTheViewer) {
  View& view = town();
  // As many texels in all.
  const auto one = error_of(view, "single/hard", {"single.size=1024"}),
             four = error_of(view, "cascaded/hard", {"cascaded.size=512"});
  report("town, one map of 1024", one);
  report("town, four maps of 512", four);
  EXPECT_LT(four.mae, 0.6 * one.mae);
}

// A wide kernel is wider in metres where texels are: across a border between cascades a straight edge's softness jumps.
TEST(Failure, SoftnessJumpsAtTheSeamsOfCascades) {
  constexpr uvec2 k_view = {240, 240};
  // The edges of long slabs run along the view, so that rows of the picture differ by the viewer's distance alone.
  View& view = test::kept_view(
      "slabs along the view",
      [] {
        std::vector<MeshPart> parts = {test::floor_part(60.0f)};
        for (float x = -40.0f; x < 40.0f; x += 8.0f) parts.push_back(test::box_part({x, 3, -60}, {x + 4, 3.2f, 20}));
        Scene scene = test::scene_with(std::move(parts));
        scene.cameras.push_back(look_at("under", {2, 2.5f, 10}, {2, 0, 2}, 60.0));
        scene.lights.push_back(test::make_sun({0.2f, -1, 0}));
        return scene;
      },
      k_view);
  const ReferenceResult& truth = test::hard_reference(view);
  // Largest change of a row's greyness from one row to the next.
  const auto jump = [&](std::string_view blend) {
    const auto mask = mask_of(view, "cascaded/pcf", {"cascaded.selection=interval", "cascaded.size=512", "pcf.size=9", blend});
    double largest = 0.0, last = -1.0;
    for (uint32_t y = 0; y < k_view.y; ++y) {
      double grey = 0.0, receivers = 0.0;
      for (uint32_t i = y * k_view.x; i < (y + 1) * k_view.x; ++i) {
        if (!truth.receiver[i]) continue;
        grey += 4.0 * double(mask[i]) * (1.0 - double(mask[i]));
        receivers += 1.0;
      }
      if (receivers < k_view.x) continue;  // floor alone
      grey /= receivers;
      if (last >= 0.0) largest = std::max(largest, std::abs(grey - last));
      last = grey;
    }
    fmt::print("softness of edges, {}: jumps by {:.4f} from one row to the next\n", blend, largest);
    return largest;
  };
  EXPECT_GT(jump("cascaded.blend=0"), 2.0 * jump("cascaded.blend=0.5"));
}

// --- Casters outside the view

// The tower of `town` stands behind the viewer and casts into the street before it.
TEST(Failure, CastersBehindTheViewerAreLostByMapsThatHoldOnlyTheView) {
  View& view = town();
  const auto by_default = error_of(view, "cascaded/hard", {}), lost = error_of(view, "cascaded/hard", {"cascaded.near=slice"});
  const auto moved = error_of(view, "cascaded/hard", {"cascaded.near=slice", "cascaded.offset=0.8"});
  report("town, every caster in the map", by_default);
  report("town, only the slices", lost);
  report("town, slices moved back by cascaded.offset", moved);
  EXPECT_GT(amount(lost.false_light), amount(by_default.false_light) + 0.03);
  EXPECT_LT(amount(moved.false_light), 0.5 * amount(lost.false_light));
}

// A slab high above the view, and a pillar within it whose top lies before the near planes of the nearest slices.
Scene slab_above() {
  Scene scene = test::scene_with(
      {test::floor_part(40.0f), test::box_part({-3, 30, -14}, {3, 31, -6}), test::box_part({4, 0, -20}, {6, 25, -18})});
  scene.cameras.push_back(look_at("below", {0, 2, 6}, {0, 1, -10}, 60.0));
  scene.lights.push_back(test::make_sun({0.1f, -1, 0.15f}));
  return scene;
}

TEST(Failure, CastersBetweenLightAndSliceAreClipped) {
  View& view = test::kept_view("slab above", slab_above, {192, 120});
  for (const std::string_view fit : {"cascaded.fit=sphere", "cascaded.fit=box"}) {
    const auto before_all = error_of(view, "cascaded/hard", {fit}),
               clamped = error_of(view, "cascaded/hard", {fit, "cascaded.near=clamp"});
    const auto clipped = error_of(view, "cascaded/hard", {fit, "cascaded.near=slice"});
    report(fmt::format("slab above, {}, near=casters", fit), before_all);
    report("near=clamp", clamped);
    report("near=slice", clipped);
    EXPECT_GT(amount(clipped.false_light), 0.03);
    EXPECT_LT(before_all.mae, 0.01);
    EXPECT_LT(clamped.mae, 0.01);
  }
}

// Points of one cascade's column that lie before its near plane: here roofs and trees that a low sun meets before the first
// slices.
TEST(Failure, DepthClampServesOnlyWhatLiesBehindTheNearPlane) {
  View& view = test::kept_view("courtyard under a low sun",
                               [] {
                                 Scene scene = load_scene("courtyard");
                                 scene.lights[0].direction = glm::normalize(vec3(-0.49f, -0.21f, 0.85f));
                                 return scene;
                               },
                               {192, 128});
  const auto by_default = error_of(view, "cascaded/hard", {}),
             clamped = error_of(view, "cascaded/hard", {"cascaded.near=clamp"});
  report("low sun, near=casters", by_default);
  report("low sun, near=clamp", clamped);
  EXPECT_LT(clamped.mae, 1.5 * by_default.mae);
}

}  // namespace
}  // namespace gnomon
