// The arithmetic of the alpha lookup.
#include "base/glsl/alpha.glsl"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.h"

namespace gnomon {
namespace {

TEST(Alpha, WrapModesAreThoseOfTheScene) {
  EXPECT_EQ(k_wrap_repeat, static_cast<uint32_t>(Wrap::repeat));
  EXPECT_EQ(k_wrap_clamp, static_cast<uint32_t>(Wrap::clamp));
  EXPECT_EQ(k_wrap_mirror, static_cast<uint32_t>(Wrap::mirror));
}

TEST(Alpha, TexelsWrap) {
  const int repeat[] = {2, 0, 1, 2, 0, 1, 2, 0, 1}, mirror[] = {2, 2, 1, 0, 0, 1, 2, 2, 1},
            clamp[] = {0, 0, 0, 0, 0, 1, 2, 2, 2};
  for (int i = -4; i < 5; ++i) {
    EXPECT_EQ(wrap_texel(i, 3, k_wrap_repeat), repeat[i + 4]) << i;
    EXPECT_EQ(wrap_texel(i, 3, k_wrap_mirror), mirror[i + 4]) << i;
    EXPECT_EQ(wrap_texel(i, 3, k_wrap_clamp), clamp[i + 4]) << i;
  }
  for (const uint mode : {k_wrap_repeat, k_wrap_clamp, k_wrap_mirror}) {
    for (const int i : {-1000000007, -1, 0, 1, 1000000007}) {
      EXPECT_EQ(wrap_texel(i, 1, mode), 0);
      EXPECT_GE(wrap_texel(i, 16384, mode), 0);
      EXPECT_LT(wrap_texel(i, 16384, mode), 16384);
    }
  }
}

TEST(Alpha, InterpolatesFromTheSecondAndThirdVertex) {
  const vec2 a(0.1f, 0.2f), b(0.7f, 0.3f), c(0.4f, 0.9f);
  EXPECT_EQ(interpolate_uv(a, b, c, 0, 0), a);
  EXPECT_EQ(interpolate_uv(a, b, c, 1, 0), b);
  EXPECT_EQ(interpolate_uv(a, b, c, 0, 1), c);
}

TEST(Alpha, TransformIsThatOfTheScene) {
  const UvTransform rotation{{0.6f, -0.8f, 0.25f}, {0.8f, 0.6f, -1.5f}};
  const vec2 uv(0.3f, 0.7f);
  EXPECT_EQ(transform_uv(rotation.row_u, rotation.row_v, uv), rotation.apply(uv));
}

TEST(Alpha, TexelCentresHaveNoNeighbours) {
  const vec2 position = texel_position(vec2(2.5f / 8.0f, 0.5f / 4.0f), ivec2(8, 4));
  EXPECT_EQ(texel_below(position), ivec2(2, 0));
  EXPECT_EQ(texel_weight(position), vec2(0.0f));
  EXPECT_EQ(texel_below(texel_position(vec2(0.0f), ivec2(8, 4))), ivec2(-1, -1));
  EXPECT_EQ(texel_weight(texel_position(vec2(0.0f), ivec2(8, 4))), vec2(0.5f));
}

TEST(Alpha, HugeCoordinatesStayIntegers) {
  const ivec2 low = texel_below(texel_position(vec2(1.0e30f, -1.0e30f), ivec2(8, 4)));
  EXPECT_EQ(low, ivec2(1000000000, -1000000000));
}

TEST(Alpha, BilinearIsExactForEqualTexelsAndAtCorners) {
  for (int i = 0; i <= 255; ++i) {
    const float a = static_cast<float>(i) / 255.0f;
    EXPECT_EQ(bilinear_alpha(a, a, a, a, vec2(0.3f, 0.77f)), a);
  }
  EXPECT_EQ(bilinear_alpha(0.1f, 0.2f, 0.3f, 0.4f, vec2(0, 0)), 0.1f);
  EXPECT_FLOAT_EQ(bilinear_alpha(0.1f, 0.2f, 0.3f, 0.4f, vec2(1, 0)), 0.2f);
  EXPECT_FLOAT_EQ(bilinear_alpha(0.1f, 0.2f, 0.3f, 0.4f, vec2(0, 1)), 0.3f);
  EXPECT_FLOAT_EQ(bilinear_alpha(0.0f, 1.0f, 0.0f, 0.0f, vec2(0.5f, 0.5f)), 0.25f);
}

}  // namespace
}  // namespace gnomon
