// The two references against each other on scenes without a closed form, and what makes a reference refuse.
#include <cmath>
#include <filesystem>

#include "base/warning_watch.h"
#include "lab/experiment/reference_set.h"
#include "reference/pipeline_reference.h"
#include "support/paths.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

constexpr uvec2 k_size = {160, 120};

struct Masks {
  ReferenceResult embree, pipeline;
};

Masks trace_both(View& view, const Light& light, bool area, int samples) {
  const auto points = view.frame().read_points();
  return {EmbreeReference(view.scene()).trace(points, view.frame().camera().eye_ws, light, area, samples, 1),
          PipelineReference(device(), view.context().acceleration_structure()).trace(view.frame(), light, area, samples, 1)};
}

void expect_agreement(const std::string& name, Scene scene) {
  if (scene.cameras.empty()) scene.cameras.push_back(framing_camera(scene, float(k_size.x) / float(k_size.y)));
  if (scene.lights.empty()) scene.lights.push_back(test::make_sun({-0.5f, -0.7f, 0.3f}));
  Light sun = scene.lights[0];
  sun.angular_diameter = 0.03f;
  View view(std::move(scene), k_size);
  view.draw();
  EXPECT_EQ(EmbreeReference(view.scene()).triangle_count(), view.context().acceleration_structure().triangle_count()) << name;

  const Masks hard = trace_both(view, sun, false, 1);
  EXPECT_EQ(hard.embree.receiver, hard.pipeline.receiver) << name;
  size_t receivers = 0, lit = 0, different = 0;
  for (size_t i = 0; i < hard.embree.visibility.size(); ++i) {
    receivers += hard.embree.receiver[i];
    lit += hard.embree.visibility[i] == 1.0f;
    different += hard.embree.visibility[i] != hard.pipeline.visibility[i];
  }
  EXPECT_GT(receivers, hard.embree.visibility.size() / 20) << name;
  EXPECT_LE(static_cast<double>(different), 2e-4 * static_cast<double>(receivers)) << name;

  constexpr int k_samples = 8;
  const Masks soft = trace_both(view, sun, true, k_samples);
  double difference = 0.0;
  for (size_t i = 0; i < soft.embree.visibility.size(); ++i)
    difference += double(soft.pipeline.visibility[i]) - double(soft.embree.visibility[i]);
  difference /= static_cast<double>(receivers);
  EXPECT_LE(std::abs(difference), std::min(soft.embree.confidence, soft.pipeline.confidence)) << name;
  fmt::print(
      "{}: {} receivers, {} lit; hard: {} differ ({:.4f} %); area: mean difference {:+.2e}, confidence {:.2e} and {:.2e}\n",
      name, receivers, lit, different, 100.0 * static_cast<double>(different) / static_cast<double>(receivers), difference,
      soft.embree.confidence, soft.pipeline.confidence);
}

TEST(ReferenceAgreement, Courtyard) { expect_agreement("courtyard", load_scene("courtyard")); }

TEST(ReferenceAgreement, Terrain) { expect_agreement("terrain", load_scene("terrain", {{"detail", 0.01}})); }

TEST(ReferenceAgreement, AlphaTestedObj) {
  const std::filesystem::path path = shared_scenes() / "alpha_obj/bonsai-tree/bonsai-tree.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not on this machine";
  expect_agreement("bonsai-tree.obj", load_scene(path.string()));
}

TEST(ReferenceAgreement, Lamps) {
  Scene scene = test::scene_with({test::floor_part(5.0f), test::box_part({-0.5f, 0.5f, -0.5f}, {0.5f, 1.0f, 0.5f})});
  scene.cameras.push_back(look_at("above", {3, 4, 3}, {0, 0, 0}, 50.0));
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.position = {0.3f, 3, 0.2f};
  lamp.intensity = 10.0f;
  lamp.range = 6.0f;
  Light spot = lamp;
  spot.kind = LightKind::spot;
  spot.direction = glm::normalize(vec3(-0.1f, -1, 0));
  spot.outer_cone = 0.5f;
  scene.lights = {lamp, spot};
  View view(std::move(scene), k_size);
  view.draw();
  for (const Light& light : view.scene().lights) {
    const Masks hard = trace_both(view, light, false, 1);
    EXPECT_EQ(hard.embree.receiver, hard.pipeline.receiver);
    size_t different = 0, lit = 0, receivers = 0;
    for (size_t i = 0; i < hard.embree.visibility.size(); ++i) {
      different += hard.embree.visibility[i] != hard.pipeline.visibility[i];
      lit += hard.embree.visibility[i] == 1.0f;
      receivers += hard.embree.receiver[i];
    }
    EXPECT_GT(lit, 100u);
    EXPECT_GT(receivers, lit + 100u);
    EXPECT_LE(different, 4u) << light_kind_name(light.kind);
  }
}

TEST(ReferenceAgreement, RayTracedIsExactlyThePipelineReference) {
  for (const uint32_t samples : {1u, 4u}) {
    const auto& counts = device().info().sample_counts;
    if (std::find(counts.begin(), counts.end(), static_cast<int>(samples)) == counts.end()) continue;
    View view(load_scene("courtyard"), {96, 72}, samples);
    view.draw();
    const auto& spec = find_technique("ray_traced");
    const auto mask = test::run_technique(view, spec, spec.default_settings()).mask;
    const auto reference = PipelineReference(device(), view.context().acceleration_structure())
                               .trace(view.frame(), view.scene().lights[0], false, 1, 1);
    const auto shares = test::read_surface<uint32_t>(view, "surface share");
    size_t compared = 0, different = 0;
    for (size_t i = 0; i < mask.size(); ++i) {
      // Samples that share an answer took their leader's: the reference traces each for itself.
      const size_t s = i % samples;
      const bool leads = ((shares[i / samples] >> (4 * s)) & 15u) == s;
      const size_t leader = i - s + ((shares[i / samples] >> (4 * s)) & 15u);
      EXPECT_EQ(mask[i], mask[leader]) << "sample " << i;
      if (!reference.receiver[i] || !leads) continue;
      ++compared;
      different += mask[i] != reference.visibility[i];
    }
    EXPECT_GT(compared, size_t{96} * 72 / 4);
    EXPECT_EQ(different, 0u) << samples << " samples";
  }
}

std::unique_ptr<Session> small_session(const char* kind, std::vector<std::string> casts = {}) {
  ViewOptions options;
  options.scene = "chart/slab";
  options.size = {64, 48};
  options.casts = std::move(casts);
  Settings settings;
  settings.assign(fmt::format("reference.kind={}", kind));
  auto session = std::make_unique<Session>(device(), options, settings);
  session->draw_surface();
  return session;
}

TEST(ReferenceRefuses, NothingWhenAllIsWell) {
  for (const char* kind : {"embree", "pipeline"}) {
    const auto session = small_session(kind);
    const ReferenceSet set = make_references(*session);
    EXPECT_EQ(set.kind, kind);
    EXPECT_EQ(set.lights.size(), 1u);
    EXPECT_EQ(rasterised_caster_triangles(*session), session->scene().triangle_count());
  }
}

TEST(ReferenceRefuses, OtherTrianglesThanTheRasteriserDraws) {
  // The scene loses a caster after it was uploaded: Embree then holds less than what is drawn.
  const auto session = small_session("embree");
  auto& scene = const_cast<Scene&>(session->scene());  // the session's own scene is not const
  scene.objects[1].casts = false;
  const std::string message = test::error_of([&] { make_references(*session); }, ExitCode::failure);
  EXPECT_NE(message.find("2 triangles"), std::string::npos) << message;
  EXPECT_NE(message.find("14 are drawn"), std::string::npos) << message;
}

TEST(ReferenceRefuses, AnEmptySetWhereSomethingIsDrawn) {
  const auto session = small_session("embree");
  auto& scene = const_cast<Scene&>(session->scene());
  for (Object& object : scene.objects) object.casts = false;
  const std::string message = test::error_of([&] { make_references(*session); }, ExitCode::failure);
  EXPECT_NE(message.find("0 triangles"), std::string::npos) << message;
}

TEST(ReferenceAgreement, WhereNothingCastsAllIsLit) {
  for (const char* kind : {"embree", "pipeline"}) {
    if (std::string_view(kind) == "pipeline" && !device().info().ray_tracing) continue;
    const WarningWatch watch;
    const auto session = small_session(kind, {"*=off"});
    ASSERT_EQ(watch.texts().size(), 1u);
    EXPECT_NE(watch.texts()[0].find("nothing casts a shadow"), std::string::npos) << watch.texts()[0];
    EXPECT_NE(watch.texts()[0].find("--cast"), std::string::npos);
    EXPECT_NE(watch.texts()[0].find("scene.blend_casts"), std::string::npos);
    EXPECT_EQ(rasterised_caster_triangles(*session), 0u);
    const ReferenceResult hard = make_references(*session).lights.at(0).hard;
    size_t receivers = 0;
    for (size_t i = 0; i < hard.visibility.size(); ++i) {
      if (!hard.receiver[i]) continue;
      ++receivers;
      EXPECT_EQ(hard.visibility[i], 1.0f) << kind;
    }
    EXPECT_GT(receivers, hard.visibility.size() / 4) << kind;
  }
}

// No projection may fit its maps to an empty box, and no filter read anything but light from them.
TEST(ReferenceAgreement, WhereNothingCastsEveryTechniqueShowsLight) {
  for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot}) {
    Scene scene = test::scene_with({test::floor_part(3.0f), test::box_part({-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f})});
    for (Object& object : scene.objects) object.casts = false;
    scene.cameras.push_back(look_at("above", {3, 4, 3}, {0, 0, 0}, 50.0));
    Light light = test::make_sun({-0.3f, -1, 0.2f});
    light.kind = kind;
    if (kind != LightKind::directional) light.position = {0.3f, 3, 0.2f}, light.range = 9.0f;
    scene.lights = {light};
    View view(std::move(scene), {32, 24});
    view.draw();
    const ReferenceResult reference =
        EmbreeReference(view.scene())
            .trace(view.frame().read_points(), view.frame().camera().eye_ws, view.scene().lights[0], false, 1, 1);
    for (const TechniqueSpec& spec : all_techniques()) {
      // Each projection once and, under the sun, each filter once: the others are made of the same.
      const bool filters = kind == LightKind::directional && spec.name.starts_with("single/");
      const bool once = filters || spec.name.ends_with("/hard") || spec.name.find('/') == spec.name.npos;
      if (!once || !spec.supports(kind)) continue;
      if (spec.name == "ray_traced" && !device().info().ray_tracing) continue;
      const auto mask = test::run_technique(view, spec, spec.default_settings()).mask;
      float darkest = 1.0f;
      for (size_t i = 0; i < mask.size(); ++i) darkest = reference.receiver[i] ? std::min(darkest, mask[i]) : darkest;
      EXPECT_GE(darkest, 0.999f) << spec.name << " " << light_kind_name(kind);
    }
  }
}

}  // namespace
}  // namespace gnomon
