// The CPU reference with one ray a point: closed forms, alpha, instances, lights, refusals.
#include "reference/cpu/embree_reference.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "base/error.h"
#include "hand_made_scene.h"

namespace gnomon {
namespace {

using namespace test;

const vec3 k_eye(0, 10, 0);

// 1 lit, 0 shadowed, -1 no receiver.
std::vector<float> hard(const Scene& scene, const Light& light, const std::vector<SurfacePoint>& points) {
  ReferenceResult result = EmbreeReference(scene).trace(points, k_eye, light, false, 1, 0);
  for (size_t i = 0; i < points.size(); ++i) {
    if (!result.receiver[i]) result.visibility[i] = -1.0f;
  }
  return result.visibility;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(EmbreeReference, QuadOverFloorHasAnExactEdge) {
  Scene scene = empty_scene();
  add(scene, floor_quad(10.0f));
  add(scene, floor_quad(1.0f, 2.0f));
  // The sun travels one metre along x for every two down: the shadow of [-1, 1] is [0, 2].
  const Light light = sun({0.5f, -1.0f, 0.0f});
  const float step = 2.0e-4f;
  EXPECT_EQ(
      hard(scene, light, {floor_point(-step, 0), floor_point(step, 0), floor_point(2 - step, 0), floor_point(2 + step, 0)}),
      (std::vector<float>{1, 0, 0, 1}));
  EXPECT_EQ(hard(scene, light,
                 {floor_point(1, -1 - step), floor_point(1, -1 + step), floor_point(1, 1 - step), floor_point(1, 1 + step)}),
            (std::vector<float>{1, 0, 0, 1}));
}

TEST(EmbreeReference, BothSidesOfATriangleCast) {
  for (const float side : {1.0f, -1.0f}) {
    Scene scene = empty_scene();
    add(scene, quad({0, 1, 0}, {side, 0, 0}, {0, 0, 1}));
    EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(0, 0)}), std::vector<float>{0});
  }
}

TEST(EmbreeReference, CountsTrianglesOfInstancesAndOnlyOfCasters) {
  Scene scene = empty_scene();
  add(scene, floor_quad(1.0f)).casts = false;
  add(scene, box(vec3(-1), vec3(1)));
  scene.objects.push_back(scene.objects.back());
  EXPECT_EQ(EmbreeReference(scene).triangle_count(), 24u);
}

TEST(EmbreeReference, WithoutCastersAllIsLit) {
  Scene scene = empty_scene();
  add(scene, floor_quad(1.0f)).casts = false;
  const EmbreeReference reference(scene);
  EXPECT_EQ(reference.triangle_count(), 0u);
  const std::vector<SurfacePoint> points = {floor_point(0, 0)};
  const ReferenceResult result = reference.trace(points, k_eye, sun({0, -1, 0}), false, 1, 0);
  EXPECT_EQ(result.receiver, std::vector<uint8_t>{1});
  EXPECT_EQ(result.visibility, std::vector<float>{1.0f});
}

TEST(EmbreeReference, RefusesPointsThatAreNotFinite) {
  Scene scene = empty_scene();
  add(scene, floor_quad(1.0f));
  const std::vector<SurfacePoint> points = {floor_point(0, 0, 1), floor_point(std::nanf(""), 0, 7)};
  EXPECT_NE(message_of([&] {
              EmbreeReference(scene).trace(points, k_eye, sun({0, -1, 0}), false, 1, 0);
            }).find("pixel 7"),
            std::string::npos);
}

TEST(EmbreeReference, SkyAndSurfacesTurnedAwayAreNoReceivers) {
  Scene scene = empty_scene();
  add(scene, floor_quad(1.0f, -5.0f));
  SurfacePoint sky = floor_point(0, 0), away = floor_point(0, 0);
  sky.object = k_no_object;
  sky.position_ws = vec3(std::nanf(""));  // whatever the surface buffer holds there
  away.geometric_normal_ws = vec3(0, -1, 0);
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {sky, away, floor_point(0, 0)}), (std::vector<float>{-1, -1, 1}));
}

TEST(EmbreeReference, PointLightSeesOnlyWhatIsBeforeIt) {
  Scene scene = empty_scene();
  add(scene, floor_quad(0.5f, 2.0f));    // between the lamp and x in [-1, 1]
  add(scene, floor_quad(9.0f, 4.001f));  // just above the lamp
  add(scene, floor_quad(9.0f, 4.0f));    // the lamp's own surface, through its centre
  const Light light = lamp({0, 4, 0});
  EXPECT_EQ(hard(scene, light, {floor_point(0, 0), floor_point(0.999f, 0), floor_point(1.001f, 0)}),
            (std::vector<float>{0, 0, 1}));
}

TEST(EmbreeReference, RangeAndConeEndReceivers) {
  Scene scene = empty_scene();
  add(scene, floor_quad(0.5f, 9.0f));
  Light light = lamp({0, 4, 0});
  light.range = 5.0f;  // reaches x = 3
  EXPECT_EQ(hard(scene, light, {floor_point(2.99f, 0), floor_point(3.01f, 0)}), (std::vector<float>{1, -1}));
  light.range = 0.0f;
  light.kind = LightKind::spot;
  light.outer_cone = std::atan(0.25f);  // reaches x = 1
  EXPECT_EQ(hard(scene, light, {floor_point(0.99f, 0), floor_point(1.01f, 0)}), (std::vector<float>{1, -1}));
}

TEST(EmbreeReference, InstancesFollowTheirTransforms) {
  Scene scene = empty_scene();
  // An L without symmetry: x in [0, 1] for z in [-1, 0], and a second quad of another part over z in [0, 1], x in [0, 0.5].
  Object& first = add(scene, quad({0.5f, 0, -0.5f}, {0, 0, 0.5f}, {0.5f, 0, 0}));
  scene.meshes[0].parts.push_back(quad({0.25f, 0, 0.5f}, {0, 0, 0.5f}, {0.25f, 0, 0}));
  first.world_from_object = glm::translate(mat4(1.0f), vec3(0, 1, 0)) * glm::scale(mat4(1.0f), vec3(4, 1, 2));
  Object mirrored = first;
  mirrored.world_from_object = glm::translate(mat4(1.0f), vec3(-1, 1, 0)) * glm::scale(mat4(1.0f), vec3(-1, 1, 1));
  scene.objects.push_back(mirrored);
  const Light light = sun({0, -1, 0});
  EXPECT_EQ(hard(scene, light,
                 {floor_point(3.99f, -1.99f), floor_point(4.01f, -1), floor_point(1.99f, 1.99f), floor_point(2.01f, 1)}),
            (std::vector<float>{0, 1, 0, 1}));
  EXPECT_EQ(hard(scene, light,
                 {floor_point(-1.99f, -0.9f), floor_point(-2.01f, -0.9f), floor_point(-1.49f, 0.9f), floor_point(-1.51f, 0.9f),
                  floor_point(-0.99f, -0.9f)}),
            (std::vector<float>{0, 1, 0, 1, 1}));
}

TEST(EmbreeReference, FlattenedObjectsCast) {
  Scene scene = empty_scene();
  add(scene, box(vec3(-1), vec3(1)), glm::translate(mat4(1.0f), vec3(0, 3, 0)) * glm::scale(mat4(1.0f), vec3(1, 0, 1)));
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(0.99f, 0), floor_point(1.01f, 0)}), (std::vector<float>{0, 1}));
}

// A quad over [-2, 2] in x and z at height 1 with 4 x 4 texels of a metre; the checker's even texels are opaque.
Scene checker_scene() {
  Scene scene = empty_scene();
  Texture texture;
  texture.image = Image8(4, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) texture.image.at(x, y)[3] = (x + y) % 2 == 0 ? 255 : 0;
  }
  scene.textures.push_back(texture);
  scene.materials[0].masked = true;
  scene.materials[0].base_colour_texture = 0;
  add(scene, quad({0, 1, 0}, {2, 0, 0}, {0, 0, 2}));
  return scene;
}

TEST(EmbreeReference, AlphaTestedCheckerCastsItsTexels) {
  const Scene scene = checker_scene();
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const float expected = (x + y) % 2 == 0 ? 0.0f : 1.0f;
      const SurfacePoint point = floor_point(static_cast<float>(x) - 1.5f, static_cast<float>(y) - 1.5f);
      EXPECT_EQ(hard(scene, sun({0, -1, 0}), {point}), std::vector<float>{expected}) << x << ' ' << y;
    }
  }
}

TEST(EmbreeReference, AlphaIsBilinearBetweenTexels) {
  Scene scene = checker_scene();
  scene.materials[0].alpha_cutoff = 0.25f;
  // Along the row of texel centres z = -1.5 alpha falls from 1 at x = -1.5 to 0 at x = -0.5: a quarter at -0.75.
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(-0.751f, -1.5f), floor_point(-0.749f, -1.5f)}),
            (std::vector<float>{0, 1}));
}

TEST(EmbreeReference, AlphaFollowsUvTransformAndWrap) {
  Scene scene = checker_scene();
  const SurfacePoint first = floor_point(-1.5f, -1.5f), border = floor_point(-1.999f, -1.5f);
  scene.materials[0].base_colour_uv.row_u.z = 0.25f;  // one texel on
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {first}), std::vector<float>{1});
  scene.materials[0].base_colour_uv.row_u.z = -0.25f;
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {first}), std::vector<float>{1}) << "repeat: the last texel";
  scene.textures[0].wrap_u = Wrap::clamp;
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {first}), std::vector<float>{0}) << "clamp: the first texel";
  // At the left border repeat mixes texels 0 and 3 half and half, mirror texel 0 with itself.
  scene.materials[0].base_colour_uv = {};
  scene.materials[0].alpha_cutoff = 0.6f;
  for (const auto& [wrap, expected] :
       {std::pair(Wrap::repeat, 1.0f), std::pair(Wrap::mirror, 0.0f), std::pair(Wrap::clamp, 0.0f)}) {
    scene.textures[0].wrap_u = wrap;
    EXPECT_EQ(hard(scene, sun({0, -1, 0}), {border}), std::vector<float>{expected});
  }
}

TEST(EmbreeReference, AlphaEqualToTheCutoffIsOpaque) {
  Scene scene = checker_scene();
  for (size_t i = 3; i < 64; i += 4) scene.textures[0].image.rgba[i] = 255;
  scene.materials[0].base_colour.w = 0.3f;
  scene.materials[0].alpha_cutoff = 0.3f;
  EXPECT_EQ(hard(scene, sun({0.1f, -1, 0.2f}), {floor_point(0.13f, 0.37f)}), std::vector<float>{0});
  scene.materials[0].base_colour_texture = k_no_texture;
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(0, 0)}), std::vector<float>{0});
  scene.materials[0].base_colour.w = 0.29f;
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(0, 0)}), std::vector<float>{1});
  scene.materials[0].masked = false;  // alpha of an opaque material is ignored
  EXPECT_EQ(hard(scene, sun({0, -1, 0}), {floor_point(0, 0)}), std::vector<float>{0});
}

TEST(EmbreeReference, ResultDoesNotDependOnTheNumberOfThreads) {
  Scene scene = empty_scene();
  add(scene, floor_quad(1.0f, 2.0f));
  std::vector<SurfacePoint> points;
  for (uint32_t i = 0; i < 5000; ++i) points.push_back(floor_point(static_cast<float>(i) * 1.0e-3f - 2.5f, 0.9f, i));
  const EmbreeReference reference(scene);
  const Light light = sun({0, -1, 0}, 0.3f);
  const ReferenceResult parallel = reference.trace(points, k_eye, light, true, 16, 1);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ReferenceResult serial = reference.trace(points, k_eye, light, true, 16, 1);
  EXPECT_EQ(parallel.visibility, serial.visibility);
  EXPECT_EQ(parallel.confidence, serial.confidence);
  EXPECT_NE(parallel.visibility, reference.trace(points, k_eye, light, true, 16, 2).visibility) << "the seed must matter";
}

}  // namespace
}  // namespace gnomon
