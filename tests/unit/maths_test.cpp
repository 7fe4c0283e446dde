// Boxes and bases.
#include "base/maths.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

TEST(Maths, BoxGrowsFromNothing) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.extent(), vec3(0.0f));
  box.add(vec3(1, 2, 3));
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.extent(), vec3(0.0f));
  box.add(vec3(-1, 4, 3));
  EXPECT_EQ(box.centre(), vec3(0, 3, 3));
  EXPECT_EQ(box.extent(), vec3(2, 2, 0));
  EXPECT_FLOAT_EQ(box.radius(), std::sqrt(2.0f));
  box.add(Box{});  // the empty box changes nothing
  EXPECT_EQ(box.extent(), vec3(2, 2, 0));
}

TEST(Maths, CornersAreNumberedByBits) {
  const Box box{vec3(0), vec3(1, 2, 3)};
  EXPECT_EQ(box.corner(0), vec3(0));
  EXPECT_EQ(box.corner(1), vec3(1, 0, 0));
  EXPECT_EQ(box.corner(6), vec3(0, 2, 3));
  EXPECT_EQ(box.corner(7), box.max);
}

TEST(Maths, TransformedBoxHoldsItsCornersTightly) {
  const Box box{vec3(-1, 0, 2), vec3(3, 1, 5)};
  const mat4 transform = glm::translate(mat4(1.0f), vec3(7, -8, 9)) *
                         glm::rotate(mat4(1.0f), 0.7f, glm::normalize(vec3(1, 2, 3))) *
                         glm::scale(mat4(1.0f), vec3(2, -1, 0.5f));
  Box corners;
  for (int i = 0; i < 8; ++i) corners.add(vec3(transform * vec4(box.corner(i), 1.0f)));
  const Box fast = transformed(transform, box);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(fast.min[axis], corners.min[axis], 1.0e-5f);
    EXPECT_NEAR(fast.max[axis], corners.max[axis], 1.0e-5f);
  }
  EXPECT_TRUE(transformed(transform, Box{}).empty());
}

TEST(Maths, BasisIsOrthonormalAndRightHanded) {
  for (const vec3 direction : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(0, 1, 0), vec3(-1, -2, -3), vec3(1e-4f, 1e-4f, -1)}) {
    const vec3 n = glm::normalize(direction);
    vec3 tangent, bitangent;
    orthonormal_basis(n, tangent, bitangent);
    EXPECT_NEAR(glm::dot(tangent, n), 0.0f, 1.0e-6f);
    EXPECT_NEAR(glm::length(tangent), 1.0f, 1.0e-6f);
    EXPECT_NEAR(glm::distance(glm::cross(tangent, bitangent), n), 0.0f, 1.0e-6f);
  }
}

}  // namespace
}  // namespace gnomon
