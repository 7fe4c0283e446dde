// glTF: scenes and animations that the user chooses, evaluated where the file is read.
#include "scene/gltf/gltf_animation.h"

#include <gtest/gtest.h>

#include "base/warning_watch.h"
#include "gltf_builder.h"
#include "scene_files.h"

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;
using Interpolation = GltfCurve::Interpolation;

SceneFileOptions at(double time_s, const std::string& animation = "") {
  SceneFileOptions options;
  options.params.time = static_cast<decltype(options.params.time)>(time_s);
  options.animation = animation;
  return options;
}

SceneFileOptions scene(const std::string& name) {
  SceneFileOptions options;
  options.gltf_scene = name;
  return options;
}

// --- curves ---

TEST(GltfCurve, LinearStandsStillOutsideItsKeys) {
  const GltfCurve curve{.interpolation = Interpolation::linear, .times = {1, 2, 4}, .width = 2, .values = {0, 10, 1, 20, 5, 0}};
  EXPECT_EQ(curve.at(-7), (std::vector<float>{0, 10}));
  EXPECT_EQ(curve.at(1), (std::vector<float>{0, 10}));
  EXPECT_EQ(curve.at(1.5), (std::vector<float>{0.5f, 15}));
  EXPECT_EQ(curve.at(2), (std::vector<float>{1, 20}));
  EXPECT_EQ(curve.at(3.5), (std::vector<float>{4, 5}));
  EXPECT_EQ(curve.at(4), (std::vector<float>{5, 0}));
  EXPECT_EQ(curve.at(1e6), (std::vector<float>{5, 0}));
}

TEST(GltfCurve, StepHoldsUntilTheNextKey) {
  const GltfCurve curve{.interpolation = Interpolation::step, .times = {0, 1, 2}, .width = 1, .values = {3, 4, 5}};
  EXPECT_EQ(curve.at(0.999)[0], 3.0f);
  EXPECT_EQ(curve.at(1)[0], 4.0f);
  EXPECT_EQ(curve.at(1.999)[0], 4.0f);
  EXPECT_EQ(curve.at(2)[0], 5.0f);
}

TEST(GltfCurve, CubicSplinePassesItsKeysWithItsTangents) {
  // p(t) = t^3 from 1 to 3 seconds: values and slopes at both ends make it exact.
  const GltfCurve curve{.interpolation = Interpolation::cubic_spline,
                        .times = {1, 3},
                        .width = 1,
                        .values = {-99, 1, 3, 27, 27, -99}};  // the outer tangents do not matter
  EXPECT_EQ(curve.at(0)[0], 1.0f);
  EXPECT_EQ(curve.at(5)[0], 27.0f);
  for (const double t : {1.25, 2.0, 2.5, 2.9}) EXPECT_NEAR(curve.at(t)[0], t * t * t, 1e-5) << t;
}

// Files hold quaternions of bytes and shorts, which are never quite unit; weights of such lengths would change the pace.
TEST(GltfCurve, RotationsOfAnyLengthTurnAtTheSamePace) {
  const float half = std::sqrt(0.5f);
  GltfCurve curve{.interpolation = Interpolation::linear,
                  .rotation = true,
                  .times = {0, 1},
                  .width = 4,
                  .values = {0, 0, 0, 1, half, 0, 0, half}};  // a quarter turn about x
  const std::vector<float> unit = curve.at(0.3);
  EXPECT_NEAR(unit[0], std::sin(0.3f * k_pi / 4.0f), 1e-6f);
  for (size_t c = 0; c < 4; ++c) curve.values[c] *= 0.5f, curve.values[4 + c] *= 1.5f;
  for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(curve.at(0.3)[c], unit[c], 1e-6f) << c;
}

TEST(GltfCurve, RotationsTakeTheShorterWayAtAnEvenPace) {
  const float angle = 1.2f;
  const auto about_y = [](float a) { return vec4(0, std::sin(0.5f * a), 0, std::cos(0.5f * a)); };
  const vec4 to = -about_y(angle);  // the same rotation, on the far side of the sphere
  const GltfCurve curve{.interpolation = Interpolation::linear,
                        .rotation = true,
                        .times = {0, 1},
                        .width = 4,
                        .values = {0, 0, 0, 1, to.x, to.y, to.z, to.w}};
  const std::vector<float> third = curve.at(1.0 / 3.0);
  const vec4 expected = about_y(angle / 3.0f);
  EXPECT_NEAR(std::abs(glm::dot(glm::make_vec4(third.data()), expected)), 1.0f, 1e-6f);

  GltfCurve cubic = curve;
  cubic.interpolation = Interpolation::cubic_spline;
  cubic.values = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_NEAR(glm::length(glm::make_vec4(cubic.at(0.5).data())), 1.0f, 1e-6f) << "made unit again";
}

// --- files ---

// A parent that moves along x from 0 to 10 in two seconds, and a child triangle 1 above it that turns about z.
GltfBuilder moving() {
  GltfBuilder b;
  const int mesh = b.mesh({{"POSITION", b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  b.add("nodes", {{"mesh", mesh}, {"translation", {0, 1, 0}}});
  b.node({{"children", {0}}});
  const float half = std::sqrt(0.5f);
  const int times = b.numbers({0, 2});
  const json walk = {{"name", "walk"},
                     {"samplers",
                      {{{"input", times}, {"output", b.positions({{0, 0, 0}, {10, 0, 0}})}},
                       {{"input", times}, {"output", b.vec4s({{0, 0, 0, 1}, {0, 0, half, half}})}, {"interpolation", "STEP"}}}},
                     {"channels",
                      {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}},
                       {{"sampler", 1}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}};
  const json grow = {{"name", "grow"},
                     {"samplers", {{{"input", times}, {"output", b.positions({{1, 1, 1}, {3, 5, 7}})}}}},
                     {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "scale"}}}}}}};
  b.root["animations"] = {walk, grow};
  return b;
}

vec3 tip(const Scene& scene) { return vec3(scene.objects.at(0).world_from_object * vec4(1, 0, 0, 1)); }

TEST(GltfAnimation, NodesStandWhereTheAnimationHasThem) {
  const GltfBuilder b = moving();
  EXPECT_LT(glm::distance(tip(b.load()), vec3(1, 1, 0)), 1e-6f);
  EXPECT_LT(glm::distance(tip(b.load(at(0.5))), vec3(3.5f, 1, 0)), 1e-6f);
  EXPECT_LT(glm::distance(tip(b.load(at(9))), vec3(10, 2, 0)), 1e-6f) << "turned at its last key, and stays";
  EXPECT_LT(glm::distance(tip(b.load(at(2, "grow"))), vec3(3, 5, 0)), 1e-6f) << "parents scale their children";
  EXPECT_LT(glm::distance(tip(b.load(at(1, "1"))), vec3(2, 3, 0)), 1e-6f) << "by number";
}

TEST(GltfAnimation, TranslationsOfBytesAndShorts) {
  GltfBuilder b = moving();
  const std::vector<int16_t> rotation = {0, 0, 0, 32767, 0, 0, 32767, 0};
  b.root["animations"][0]["samplers"][1] = {{"input", b.numbers({0, 1})},
                                            {"output", b.accessor(rotation, "VEC4", test_files::k_short, 2, true)}};
  EXPECT_LT(glm::distance(tip(b.load(at(1))), vec3(5 - 1, 1, 0)), 1e-5f);
}

TEST(GltfAnimation, BadNamesListTheValidOnes) {
  const GltfBuilder b = moving();
  EXPECT_EQ(b.error(at(0, "run")), "test.gltf: --animation run: valid: 0 ('walk'), 1 ('grow')");
  EXPECT_EQ(b.error(at(0, "2")), "test.gltf: --animation 2: valid: 0 ('walk'), 1 ('grow')");
  GltfBuilder still;
  still.triangle();
  EXPECT_EQ(still.error(at(0, "walk")), "test.gltf: --animation walk: the file has no animations");
  EXPECT_EQ(still.error(at(2)), "test.gltf: --time 2: the file has no animations");
  try {
    b.load(at(0, "run"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
  }
}

TEST(GltfAnimation, DamageIsReportedWithItsPlace) {
  const auto error_with = [](const std::string& pointer, const json& value) {
    GltfBuilder b = moving();
    b.root[json::json_pointer(pointer)] = value;
    return b.error(at(1));
  };
  const std::string place = "test.gltf: animations[0].";
  EXPECT_TRUE(
      error_with("/animations/0/samplers/0/interpolation", "SMOOTH").starts_with(place + "samplers[0].interpolation: "));
  EXPECT_TRUE(error_with("/animations/0/samplers/0/input", 99).starts_with(place + "samplers[0].input: "));
  EXPECT_TRUE(error_with("/animations/0/samplers/0/input", 0).starts_with(place + "samplers[0].input: ")) << "positions";
  EXPECT_TRUE(error_with("/animations/0/samplers/0/output", 1).starts_with(place + "samplers[0].output: ")) << "times";
  EXPECT_TRUE(error_with("/animations/0/samplers/0/interpolation", "CUBICSPLINE").starts_with(place + "samplers[0].output: "));
  EXPECT_TRUE(error_with("/animations/0/channels/0/sampler", 2).starts_with(place + "channels[0].sampler: "));
  EXPECT_TRUE(error_with("/animations/0/channels/0/target/node", 7).starts_with(place + "channels[0].target.node: "));
  GltfBuilder b = moving();
  b.root["animations"][0]["samplers"][0]["input"] = b.numbers({2, 2});
  EXPECT_TRUE(b.error().starts_with(place + "samplers[0].input: key 1 ")) << b.error();
  EXPECT_EQ(b.error(at(0, "grow")), "no error") << "an animation that is not asked for may be damaged";
}

TEST(GltfAnimation, WhatIsLeftOutIsSaid) {
  GltfBuilder b = moving();
  b.root["animations"][0]["channels"][0]["target"] = {{"path", "pointer"}};
  b.root["nodes"][0].erase("translation");
  b.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1};
  const WarningWatch watch;
  EXPECT_LT(glm::distance(tip(b.load(at(2))), vec3(1, 1, 0)), 1e-6f);
  ASSERT_EQ(watch.texts().size(), 1u);
  EXPECT_TRUE(watch.texts()[0].starts_with("test.gltf: animations[0]: 2 channels move nothing")) << watch.texts()[0];
}

TEST(GltfScenes, AreChosenByNameAndNumber) {
  GltfBuilder b;
  b.triangle();
  b.add("nodes", {{"mesh", 0}, {"translation", {5, 0, 0}}});
  b.add("nodes", {{"mesh", 0}, {"translation", {0, 9, 0}}});
  b.root["scenes"] = {{{"name", "one"}, {"nodes", {0}}}, {{"nodes", {1}}}, {{"name", "1"}, {"nodes", {1, 2}}}};
  b.root["scene"] = 1;
  EXPECT_EQ(b.load().bounds().min.x, 5.0f) << "the default";
  EXPECT_EQ(b.load(scene("one")).bounds().min.x, 0.0f);
  EXPECT_EQ(b.load(scene("0")).bounds().max.x, 1.0f);
  EXPECT_EQ(b.load(scene("1")).objects.size(), 2u) << "names go before numbers";
  EXPECT_EQ(b.error(scene("two")), "test.gltf: --gltf-scene two: valid: 0 ('one'), 1, 2 ('1')");
  EXPECT_EQ(b.error(scene("3")), "test.gltf: --gltf-scene 3: valid: 0 ('one'), 1, 2 ('1')");
  b.root.erase("scenes"), b.root.erase("scene");
  EXPECT_EQ(b.load().objects.size(), 3u);
  EXPECT_EQ(b.error(scene("one")), "test.gltf: --gltf-scene one: valid: nothing, the file has no scenes");
}

TEST(GltfScenes, HiddenNodesAreNotThere) {
  GltfBuilder b;
  b.triangle();
  b.add("nodes", {{"mesh", 0}});
  b.root["nodes"][0]["children"] = {1};
  EXPECT_EQ(b.load().objects.size(), 2u);
  b.root["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  b.root["extensionsRequired"] = {"KHR_node_visibility"};
  EXPECT_EQ(b.load().objects.size(), 0u) << "nor is what hangs below them";
}

}  // namespace
}  // namespace gnomon
