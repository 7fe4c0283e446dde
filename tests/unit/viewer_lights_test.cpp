// Lights of the viewer's state: edits rewrite the texts.
#include <gtest/gtest.h>

#include "app/viewer/lights/light_list.h"
#include "base/error.h"
#include "lab/view/light_text.h"

namespace gnomon::viewer {
namespace {

Light lamp(const std::string& name, LightKind kind) {
  Light light = usual_light(kind, vec3(1, 2, 3), 10.0f).light;
  light.name = name;
  return light;
}

ViewState one_state() {
  ViewState state;
  state.techniques = {"cascaded/pcf"};
  return state;
}

TEST(ViewerLights, untouched_ones_are_the_sessions) {
  const std::vector<Light> lights = {lamp("sun", LightKind::directional), lamp("desk", LightKind::spot)};
  const auto list = lights_of(one_state(), lights);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].light.name, "desk");
}

TEST(ViewerLights, an_edit_writes_all_out_and_takes_over_from_the_settings) {
  const std::vector<Light> lights = {lamp("sun", LightKind::directional), lamp("desk", LightKind::spot)};
  ViewState state = one_state();
  state.base.assign("light.azimuth=10");
  state.base.assign("pcf.size=5");
  state.edits["light.elevation"] = "20";
  ListedLight desk = lights_of(state, lights)[1];
  desk.light.intensity = 77.0f;
  desk.aim_at(vec3(0, 0, 0));
  set_light(state, lights, 1, desk);
  ASSERT_EQ(state.view.lights.size(), 2u);
  EXPECT_EQ(state.base.assignments(), std::vector<std::string>{"pcf.size=5"});
  EXPECT_TRUE(state.edits.empty());
  const auto list = lights_of(state, {});
  EXPECT_EQ(list[1].light.intensity, 77.0f);
  EXPECT_LT(glm::length(list[1].target()), 1e-5f);
  // The other one keeps its text, to the letter.
  const std::string sun = state.view.lights[0];
  set_light(state, lights, 1, list[1]);
  EXPECT_EQ(state.view.lights[0], sun);
}

TEST(ViewerLights, added_ones_have_names_and_techniques) {
  const std::vector<Light> lights = {lamp("sun", LightKind::directional)};
  ViewState state = one_state();
  add_light(state, lights, usual_light(LightKind::point, vec3(0), 10.0f));
  add_light(state, lights, usual_light(LightKind::point, vec3(0), 10.0f));
  const auto list = lights_of(state, {});
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].light.name, "point");
  EXPECT_EQ(list[2].light.name, "point 2");
  EXPECT_NE(technique_for(state.techniques, LightKind::point), nullptr);
  EXPECT_EQ(state.techniques.front(), "cascaded/pcf");
}

TEST(ViewerLights, those_without_a_technique_get_one) {
  const std::vector<Light> lights = {lamp("sun", LightKind::directional), lamp("lamp", LightKind::point),
                                     lamp("spot", LightKind::spot)};
  ViewState state = one_state();
  state.techniques = {"cascaded/vsm"};
  state.complete_techniques(lights);
  EXPECT_EQ(state.techniques, (std::vector<std::string>{"cascaded/vsm", "cube/pcf", "single/pcf"}));
  // Those of before, where they serve.
  state.techniques = {"cascaded/vsm"};
  state.complete_techniques(lights, std::vector<std::string>{"cascaded/pcf", "dual_paraboloid/hard", "single/vsm"});
  EXPECT_EQ(state.techniques, (std::vector<std::string>{"cascaded/vsm", "dual_paraboloid/hard", "single/vsm"}));
  state.techniques = {"ray_traced"};
  state.complete_techniques(lights);
  EXPECT_EQ(state.techniques, std::vector<std::string>{"ray_traced"});
}

TEST(ViewerLights, settings_go_with_the_name) {
  const std::vector<Light> lights = {lamp("sun", LightKind::directional), lamp("lamp, left", LightKind::spot)};
  ViewState state = one_state();
  state.base.assign("lamp, left@pcf.size=5");
  state.edits["sun@pcf.size"] = "7";
  ListedLight left = lights_of(state, lights)[1];
  set_light(state, lights, 1, left);  // a comma cannot stand in a text
  EXPECT_EQ(state.base.assignments(), std::vector<std::string>{"lamp_ left@pcf.size=5"});
  left.light.name = "left";
  set_light(state, lights, 1, left);
  EXPECT_EQ(state.base.assignments(), std::vector<std::string>{"left@pcf.size=5"});
  EXPECT_EQ(state.edits.at("sun@pcf.size"), "7");
  left.light.name = "sun";
  EXPECT_THROW(set_light(state, lights, 1, left), Error);
  remove_light(state, lights, 0);
  EXPECT_TRUE(state.edits.empty());
  EXPECT_THROW(remove_light(state, lights, 0), Error);
}

TEST(ViewerLights, techniques_in_force_are_those_that_a_light_takes) {
  Light sun, lamp;
  sun.kind = LightKind::directional, lamp.kind = LightKind::point;
  const std::vector<std::string> names = {"single/pcf", "cube/pcf"}, sun_only = {"single/pcf"};
  EXPECT_EQ(names_in_force(names, std::vector{sun}), sun_only);
  EXPECT_EQ(names_in_force(names, std::vector{sun, lamp, sun}), names);
}

}  // namespace
}  // namespace gnomon::viewer
