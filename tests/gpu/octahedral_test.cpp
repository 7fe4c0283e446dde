// The 32-bit normals of the surface buffer: the shader's own text, compiled for the CPU.
#include "frame/glsl/octahedral.glsl"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

double angle_degrees(const vec3& a, const vec3& b) {
  const glm::dvec3 x(a), y(b);
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)) * 180.0 / glm::pi<double>();
}

TEST(Octahedral, ErrorIsBelowTheStatedBound) {
  double worst = 0.0;
  constexpr int k_directions = 400000;
  for (int i = 0; i < k_directions; ++i) {  // a spiral over the sphere
    const double z = 1.0 - 2.0 * (i + 0.5) / k_directions, phi = i * 2.399963229728653, r = std::sqrt(1.0 - z * z);
    const vec3 n(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
    worst = std::max(worst, angle_degrees(n, unpack_normal(pack_normal(n))));
  }
  EXPECT_LT(worst, 0.004);
  EXPECT_GT(worst, 0.0005) << "the bound says nothing about this code";
}

TEST(Octahedral, AxesAndFoldsAreExact) {
  for (const float sign : {1.0f, -1.0f}) {
    for (int axis = 0; axis < 3; ++axis) {
      vec3 n(0.0f);
      n[axis] = sign;
      const vec3 back = unpack_normal(pack_normal(n));
      EXPECT_EQ(back, n) << axis << " " << sign;
    }
    // On the fold z = 0 both halves meet.
    const vec3 n = glm::normalize(vec3(0.6f, sign * 0.8f, 0.0f));
    EXPECT_LT(angle_degrees(n, unpack_normal(pack_normal(n))), 0.004);
    EXPECT_LT(angle_degrees(n, unpack_normal(pack_normal(vec3(n.x, n.y, -1e-7f)))), 0.004);
  }
}

TEST(Octahedral, ResultIsUnit) {
  for (uint32_t word = 0; word < 0xffff0000u; word += 65521u * 3u)
    EXPECT_NEAR(glm::length(unpack_normal(word)), 1.0f, 1e-6f) << word;
}

}  // namespace
}  // namespace gnomon
