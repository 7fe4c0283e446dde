// What 32-bit floats can draw, and what is said of the rest.
#include "scene/drawable.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/warning_watch.h"
#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"
#include "scene/casting.h"
#include "scene/subject.h"

namespace gnomon {
namespace {

// A floor and a table above it, `scale` times as large as in metres.
Scene table(float scale, const mat4& placed = mat4(1.0f)) {
  Scene scene = test::empty_scene();
  test::add(scene, test::floor_quad(5.0f * scale), placed).name = "floor";
  test::add(scene, test::floor_quad(scale, 2.0f * scale), placed).name = "table";
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    check_drawable(scene);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::failure);
    return error.what();
  }
  return "";
}

TEST(Drawable, WhatIsAcceptedHasItsShadowInTheReference) {
  for (const float scale : {1e-6f, 1e-4f, 1e-3f, 1.0f, 1e4f, 5e8f}) {
    const Scene scene = table(scale);
    ASSERT_EQ(refusal(scene), "") << scale;
    const std::vector<SurfacePoint> points = {test::floor_point(0.5f * scale, 0.2f * scale),
                                              test::floor_point(3.0f * scale, 0.2f * scale)};
    const auto result = EmbreeReference(scene).trace(points, vec3(0, 10, 0) * scale, test::sun({0.1f, -1, 0.1f}), false, 1, 0);
    EXPECT_EQ(result.visibility, (std::vector<float>{0, 1})) << scale;
  }
}

TEST(Drawable, TooSmallTooLargeAndFlatAreRefusedWithTheReason) {
  const auto expect = [](const Scene& scene, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_NE(refusal(scene).find(part), std::string::npos) << refusal(scene);
  };
  expect(table(1e-40f), {"hand-made: nothing to draw", "across", "1e-06"});
  expect(table(2e-8f), {"nothing to draw", "2e-07 m across", "1e-06"});
  expect(table(1e20f), {"'floor'", "5e+20", "4e+09"});
  expect(table(1.0f, glm::scale(mat4(1.0f), vec3(1e12f))), {"'floor'", "placed at", "4e+09"});
  expect(table(1e12f, glm::scale(mat4(1.0f), vec3(1e-12f))), {"'floor'", "4e+09"});
  expect(table(1.0f, glm::scale(mat4(1.0f), vec3(0.0f))), {"nothing to draw", "scaled by 0"});
  expect(table(1.0f, glm::scale(mat4(1.0f), vec3(1, 0, 0))), {"nothing to draw", "lines"});
  expect(test::empty_scene(), {"nothing to draw", "no triangles"});
}

// One triangle of the file, and the references would not agree on it.
TEST(Drawable, AVertexBeyondFloatsIsRefusedByItsObjectAndPlace) {
  Scene scene = table(1.0f);
  scene.meshes[1].parts[0].positions[2].y = 1e20f;
  EXPECT_NE(refusal(scene).find("'table'"), std::string::npos);
  EXPECT_NE(refusal(scene).find("1e+20"), std::string::npos);
}

TEST(Drawable, StraysAreNamedAndLargeGroundsAreNot) {
  const auto warnings = [](const Scene& scene) {
    const WarningWatch watch;
    warn_of_strays(scene);
    return watch.texts();
  };
  Scene scene = table(1.0f);
  test::add(scene, test::grid(8, 8, [](double u, double v) { return glm::dvec3(u, 1.0, v); }));
  EXPECT_TRUE(warnings(scene).empty());
  MeshPart ground = test::floor_quad(2000.0f, -1.0f);
  test::add(scene, ground).name = "ground";
  EXPECT_TRUE(warnings(scene).empty());
  scene.meshes[1].parts[0].positions[3] = vec3(1e9f, -3, 7);
  const auto texts = warnings(scene);
  ASSERT_EQ(texts.size(), 1u);
  for (const char* part : {"'table'", "(1e+09, -3, 7)", "--cast 'table=off'"})
    EXPECT_NE(texts[0].find(part), std::string::npos) << texts[0];
  EXPECT_GT(shadowed_bounds(scene).max.x, 9e8f);
  apply_casting(scene, std::vector<std::string>{"table=off"});
  EXPECT_TRUE(warnings(scene).empty()) << "the user knows";
  EXPECT_LT(shadowed_bounds(scene).max.x, 3000.0f) << "and maps do not reach there";
}

}  // namespace
}  // namespace gnomon
