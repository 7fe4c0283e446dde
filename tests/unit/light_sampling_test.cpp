// Who receives light, and where the samples of an emitter lie.
#include "base/glsl/light_sampling.glsl"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/light_shape.h"

namespace gnomon {
namespace {

LightShape spot_shape() {
  Light light;
  light.kind = LightKind::spot;
  light.position = vec3(0, 5, 0);
  light.direction = vec3(0, -1, 0);
  light.radius = 0.5f;
  light.outer_cone = k_pi / 4.0f;
  light.range = 6.0f;
  return light_shape(light, true);
}

TEST(LightSampling, KindsAreThoseOfTheScene) {
  EXPECT_EQ(k_light_directional, static_cast<uint32_t>(LightKind::directional));
  EXPECT_EQ(k_light_point, static_cast<uint32_t>(LightKind::point));
  EXPECT_EQ(k_light_spot, static_cast<uint32_t>(LightKind::spot));
}

TEST(LightSampling, ShapeOfALight) {
  Light light;
  light.angular_diameter = 0.2f;
  light.range = 3.0f;  // means nothing to a sun
  EXPECT_FLOAT_EQ(light_shape(light, true).emitter_radius, std::tan(0.1f));
  EXPECT_EQ(light_shape(light, false).emitter_radius, 0.0f);
  EXPECT_EQ(light_shape(light, true).range, 0.0f);
}

TEST(LightSampling, BasisIsOrthonormalAndRightHanded) {
  for (const vec3 direction :
       {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(1, 2, -3), vec3(1e-4f, 0, -1), vec3(-3, 1, 0)}) {
    const vec3 n = glm::normalize(direction);
    const mat3 basis = basis_around(n);
    const mat3 product = glm::transpose(basis) * basis;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1.0f : 0.0f, 1.0e-6f);
    }
    EXPECT_EQ(basis[2], n);
    EXPECT_NEAR(glm::determinant(basis), 1.0f, 1.0e-6f);
  }
}

TEST(LightSampling, ReceiversFaceTheLightWithinConeAndRange) {
  const LightShape light = spot_shape();
  const vec3 up(0, 1, 0);
  EXPECT_TRUE(receives_light(light, vec3(3.2f, 0, 0), up));
  EXPECT_FALSE(receives_light(light, vec3(3.4f, 0, 0), up)) << "range";
  EXPECT_FALSE(receives_light(light, vec3(2.1f, 3, 0), up)) << "cone";
  EXPECT_FALSE(receives_light(light, vec3(0), -up));
  EXPECT_FALSE(receives_light(light, vec3(0, 6, 0), -up)) << "behind a spot light";
  EXPECT_FALSE(receives_light(light, light.position, up)) << "on the light";
  LightShape lamp = light;
  lamp.kind = k_light_point;
  EXPECT_TRUE(receives_light(lamp, vec3(0, 6, 0), -up));
  lamp.kind = k_light_directional;
  EXPECT_TRUE(receives_light(lamp, vec3(1000, 0, 0), up));
  EXPECT_FALSE(receives_light(lamp, vec3(0), vec3(1, 0, 0))) << "edge on";
}

TEST(LightSampling, SunRaysFillItsCone) {
  Light light;
  light.direction = glm::normalize(vec3(1, -2, 0.5f));
  light.angular_diameter = 0.3f;
  const LightShape shape = light_shape(light, true);
  vec3 mean(0.0f);
  float widest = 0.0f;
  for (uint32_t i = 0; i < 1024; ++i) {
    const LightRay ray = light_ray(shape, vec3(3, 4, 5), light_sample(i, 17, 1));
    EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1.0e-6f);
    EXPECT_EQ(ray.distance, k_ray_endless);
    widest = std::max(widest, std::acos(std::min(1.0f, glm::dot(ray.direction, -light.direction))));
    mean += ray.direction;
  }
  EXPECT_LE(widest, 0.15f + 1.0e-3f);
  EXPECT_GT(widest, 0.145f);
  EXPECT_GT(glm::dot(glm::normalize(mean), -light.direction), 0.99999f);
}

TEST(LightSampling, LampRaysEndOnADiscThatFacesTheOrigin) {
  const LightShape light = spot_shape();
  const vec3 origin(2, 0, 1);
  const vec3 axis = glm::normalize(light.position - origin);
  for (uint32_t i = 0; i < 64; ++i) {
    const LightRay ray = light_ray(light, origin, light_sample(i, 3, 9));
    const vec3 from_centre = origin + ray.direction * ray.distance - light.position;
    EXPECT_NEAR(glm::dot(from_centre, axis), 0.0f, 2.0e-5f);
    EXPECT_LE(glm::length(from_centre), 0.5f + 2.0e-5f);
  }
}

TEST(LightSampling, HardRaysGoToTheCentreAndStopBeforeIt) {
  LightShape light = spot_shape();
  light.emitter_radius = 0.0f;
  const vec3 origin(3, 1, 0);
  const LightRay ray = light_ray(light, origin, vec2(0.123f, 0.9f));
  EXPECT_EQ(ray.direction, glm::normalize(light.position - origin));
  EXPECT_LT(ray.distance, 5.0f);
  EXPECT_GT(ray.distance, 5.0f - 1.0e-4f);
}

TEST(LightSampling, PixelsAndSeedsAreIndependent) {
  EXPECT_NE(light_sample(0, 1, 1), light_sample(0, 2, 1));
  EXPECT_NE(light_sample(0, 1, 1), light_sample(0, 1, 2));
  EXPECT_NE(light_sample(0, 1, 2), light_sample(0, 2, 1));
  EXPECT_EQ(light_sample(5, 1, 2), light_sample(5, 1, 2));
}

}  // namespace
}  // namespace gnomon
