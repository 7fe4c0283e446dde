// Lights written on the command line.
#include "lab/view/light_text.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace gnomon {
namespace {

TEST(light_text, each_kind_with_its_defaults) {
  const auto point = parse_light("point:1,2.5,-3");
  ASSERT_TRUE(point);
  EXPECT_EQ(point->kind, LightKind::point);
  EXPECT_EQ(point->position, vec3(1, 2.5f, -3));
  EXPECT_EQ(point->name, "point");
  EXPECT_EQ(point->range, 0.0f);
  const auto spot = parse_light("spot:0,4,0:0,0,0");
  ASSERT_TRUE(spot);
  EXPECT_EQ(spot->kind, LightKind::spot);
  EXPECT_EQ(spot->direction, vec3(0, -1, 0));
  const auto projector = parse_light("projector:0,4,0:4,4,0:beam=2");
  ASSERT_TRUE(projector);
  EXPECT_EQ(projector->kind, LightKind::projector);
  EXPECT_EQ(projector->direction, vec3(1, 0, 0));
  EXPECT_EQ(projector->beam_radius, 2.0f);
  const auto sun = parse_light("sun:90,0");
  ASSERT_TRUE(sun);
  EXPECT_EQ(sun->kind, LightKind::directional);
  EXPECT_LT(glm::length(sun->direction - vec3(-1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::length(parse_light("sun:0,90")->direction - vec3(0, -1, 0)), 1e-6f);
}

TEST(light_text, keys) {
  const auto spot =
      parse_light("spot:0,4,0:0,0,0:intensity=250,radius=0.1,range=20,inner=10,outer=30,colour=1/0.5/0.25,name=desk");
  ASSERT_TRUE(spot);
  EXPECT_EQ(spot->intensity, 250.0f);
  EXPECT_EQ(spot->radius, 0.1f);
  EXPECT_EQ(spot->range, 20.0f);
  EXPECT_NEAR(spot->inner_cone, k_pi / 18.0f, 1e-6f);
  EXPECT_NEAR(spot->outer_cone, k_pi / 6.0f, 1e-6f);
  EXPECT_EQ(spot->colour, vec3(1.0f, 0.5f, 0.25f));
  EXPECT_EQ(spot->name, "desk");
  EXPECT_NEAR(parse_light("sun:10,20:angular_diameter=2")->angular_diameter, k_pi / 90.0f, 1e-6f);
  EXPECT_NEAR(parse_light("projector:0,1,0:0,0,0:angular_diameter=1")->angular_diameter, k_pi / 180.0f, 1e-6f);
}

void expect_same(const Light& a, const Light& b, const std::string& text) {
  EXPECT_EQ(a.name, b.name) << text;
  EXPECT_EQ(a.kind, b.kind) << text;
  EXPECT_EQ(a.position, b.position) << text;
  const float turned = a.kind == LightKind::point ? 0.0f : glm::length(a.direction - b.direction);
  EXPECT_LT(turned, 3e-7f) << text;
  EXPECT_EQ(a.colour, b.colour) << text;
  for (float Light::*member :
       {&Light::intensity, &Light::angular_diameter, &Light::radius, &Light::range, &Light::inner_cone, &Light::outer_cone}) {
    EXPECT_FLOAT_EQ(a.*member, b.*member) << text;
  }
  EXPECT_EQ(a.beam_radius, b.beam_radius) << text;
}

TEST(light_text, what_is_written_reads_the_same) {
  for (const char* text : {"sun:0,90", "sun:0,-90", "sun:135,50", "sun:-179.9,0.01", "sun:33.333,89.99", "point:1,2.5,-3",
                           "point:0.1,1e-06,12345.678", "spot:0,4,0:0,0,0",
                           "spot:0,4,0:0,0,0:intensity=250,radius=0.1,range=20,inner=10,outer=30,colour=1/0.5/0.25,name=desk",
                           "spot:1e5,2e5,3e5:1e5,2e5,2.9e5:outer=12.3456", "projector:0,4,0:4,4,0:beam=2,angular_diameter=0.77",
                           "sun:10,20:angular_diameter=0,intensity=12345.67"}) {
    const Light light = *parse_light(text);
    for (const float reach : {0.01f, 1.0f, 1234.5f}) {
      const std::string written = light_text(light, reach);
      expect_same(*parse_light(written), light, text + std::string(" -> ") + written);
    }
  }
}

TEST(light_text, is_written_as_people_write_it) {
  for (const char* text : {"sun:135,50", "sun:-12.5,30:angular_diameter=2", "point:1,2.5,-3:intensity=40",
                           "spot:0,4,0:0,0,0:name=desk,inner=10,outer=30", "projector:0,4,0:4,4,0:colour=1/0.5/0.25,beam=2"}) {
    EXPECT_EQ(light_text(*parse_light(text), light_reach(text)), text);
  }
}

TEST(light_text, numbers_out_of_range_move_to_its_end) {
  Light light = *parse_light("spot:0,4,0:0,0,0");
  light.intensity = 1e12f;
  EXPECT_EQ(parse_light(light_text(light))->intensity, 1e9f);
}

TEST(light_text, other_words_are_no_lights) {
  for (const char* text : {"", "moon", "sun", "all", "lamp:1,2,3", "points:1,2,3", "3", "spot"})
    EXPECT_FALSE(parse_light(text)) << text;
}

void expect_refused(const char* text, const char* says) {
  try {
    parse_light(text);
    ADD_FAILURE() << text << " was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << text << ": " << error.what();
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(light_text, what_is_wrong_is_named_with_what_is_valid) {
  expect_refused("point:1,2", "point:x,y,z");
  expect_refused("point:1,2,3,4", "point:x,y,z");
  expect_refused("point:1,2,nan", "point:x,y,z");
  expect_refused("point:1,2,3:4,5,6", "key=value");
  expect_refused("spot:1,2,3", "spot:x,y,z:tx,ty,tz");
  expect_refused("spot:1,2,3:1,2,3", "away from the light");
  expect_refused("sun:10", "sun:azimuth,elevation");
  expect_refused("sun:10,95", "-90 to 90");
  expect_refused("point:1,2,3:beam=2", "radius, range");
  expect_refused("point:1,2,3:intensity=-1", "valid: 0 to");
  expect_refused("point:1,2,3:intensity=bright", "valid: 0 to");
  expect_refused("point:1,2,3:colour=1/2", "r/g/b");
  expect_refused("point:1,2,3:colour=1/2/-3", "r/g/b");
  expect_refused("spot:0,1,0:0,0,0:outer=120", "90");
  expect_refused("spot:0,1,0:0,0,0:inner=60,outer=30", "outer");
  expect_refused("point:1,2,3:", "key=value");
  expect_refused("point:1,2,3:radius=1:range=2", "key=value");
  expect_refused("point:1,2,3:name=", "name");
}

}  // namespace
}  // namespace gnomon
