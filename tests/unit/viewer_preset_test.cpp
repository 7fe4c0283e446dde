// A state of the viewer goes through its command and its preset, and is the same again.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "app/viewer/lights/light_list.h"
#include "app/viewer/state/view_preset.h"
#include "base/error.h"

namespace gnomon::viewer {
namespace {

// What `gnomon render` makes of the words of a command, as far as ViewState::command writes them.
ViewState read_command(const std::string& command) {
  std::vector<std::string> words(1);
  bool quoted = false, plain = false;
  for (const char letter : command) {
    if (std::exchange(plain, !quoted && letter == '\\')) {
      words.back() += letter;
    } else if (plain) {
      continue;
    } else if (letter == '\'') {
      quoted = !quoted;
    } else if (letter == ' ' && !quoted) {
      words.emplace_back();
    } else {
      words.back() += letter;
    }
  }
  ViewState state;
  state.view.scene = words.at(2);
  for (size_t i = 3; i + 1 < words.size(); i += 2) {
    const std::string &option = words[i], &value = words[i + 1];
    if (option == "--size") {
      const size_t x = value.find('x');
      state.view.size = {std::stoul(value.substr(0, x)), std::stoul(value.substr(x + 1))};
    } else if (option == "--samples") {
      state.view.samples = static_cast<uint32_t>(std::stoul(value));
    } else if (option == "--camera") {
      state.view.camera = value;
    } else if (option == "--light") {
      state.view.lights.push_back(value);
    } else if (option == "--technique") {
      for (size_t at = 0; at != value.npos;) {
        const size_t comma = value.find(',', at);
        state.techniques.push_back(value.substr(at, comma == value.npos ? comma : comma - at));
        at = comma == value.npos ? comma : comma + 1;
      }
    } else if (option == "--set") {
      state.base.assign(value);
    } else {
      ADD_FAILURE() << option;
    }
  }
  return state;
}

void expect_same(const ViewState& a, const ViewState& b, std::span<const std::string> light_names) {
  EXPECT_EQ(a.view.scene, b.view.scene);
  EXPECT_EQ(a.view.size, b.view.size);
  EXPECT_EQ(a.view.samples, b.view.samples);
  EXPECT_EQ(a.view.camera, b.view.camera);
  EXPECT_EQ(a.view.lights, b.view.lights);
  EXPECT_EQ(a.techniques, b.techniques);
  const Settings first = a.settings(), second = b.settings();
  for (const auto& [id, table] : lab_tables()) EXPECT_EQ(first.block(id).to_json(), second.block(id).to_json()) << id;
  for (const char* key : {"light.azimuth", "light.elevation", "light.angular_diameter", "light.intensity",
                          "camera.vertical_fov", "camera.near"}) {
    EXPECT_EQ(first.was_set(key), second.was_set(key)) << key;
  }
  for (const std::string& technique : a.techniques) {
    const TechniqueSpec& spec = find_technique(technique);
    for (const std::string& light : light_names) {
      const SettingsMap in_first = first.for_technique(spec, light), in_second = second.for_technique(spec, light);
      for (const auto& [id, block] : in_first)
        EXPECT_EQ(block.to_json(), in_second.at(id).to_json()) << technique << " " << light << " " << id;
    }
  }
}

ViewState edited_state() {
  ViewState state;
  state.view = {.scene = "courtyard", .size = {640, 360}, .samples = 4};
  state.view.camera = "1.5,2.25,-3:0.1,0.2,0.3";
  state.techniques = {"cascaded/pcf", "cube/vsm", "ray_traced"};  // two serve suns: the first is meant
  state.base.assign("pcf.size=5");
  state.base.assign("scene.seed=3");
  state.edits = {{"camera.vertical_fov", "47.123"}, {"camera.near", "0.05"}, {"frame.ambient", "0.1"},
                 {"cascaded.lambda", "0.33333334"}, {"pcf.size", "7"},       {"Light.001@bias.constant", "1.5"},
                 {"sun@cascaded.count", "3"},       {"single.size", "333"}};
  Light sun = usual_light(LightKind::directional, vec3(0), 10.0f).light;
  ListedLight lamp = usual_light(LightKind::point, vec3(1, 2, 3), 10.0f);
  lamp.light.name = "Light.001";
  add_light(state, std::array{sun}, lamp);
  ListedLight spot = usual_light(LightKind::spot, vec3(1, 2, 3), 10.0f);
  spot.light.name = "it's";
  add_light(state, {}, spot);
  return state;
}

const std::vector<std::string> k_names = {"sun", "Light.001", "it's"};

TEST(ViewerPreset, the_preset_of_a_state_is_the_state) {
  const ViewState state = edited_state();
  const Preset preset = parse_preset(preset_text(preset_of(state, state.view.size)), "mine.json");
  EXPECT_TRUE(preset.together);
  const ViewState again = with_preset(state, preset, false);
  expect_same(again, state, k_names);
  // From another state of the scene.
  ViewState other;
  other.view = {.scene = "courtyard", .size = {640, 360}, .camera = "frame", .lights = {"sun"}};
  other.techniques = {"single/hard"};
  other.edits = {{"light.azimuth", "5"}, {"frame.specular", "true"}, {"pcf.size", "3"}};
  expect_same(with_preset(other, preset, false), state, k_names);
}

TEST(ViewerPreset, what_the_scene_decides_stays_its_decision) {
  ViewState state;
  state.view.scene = "courtyard";
  state.techniques = {"single/hard"};
  const Preset preset = parse_preset(preset_text(preset_of(state, {100, 100})), "mine.json");
  EXPECT_TRUE(preset.lights.empty() && !preset.camera);
  ViewState other = edited_state();
  const ViewState again = with_preset(other, preset, false);
  EXPECT_TRUE(again.view.lights.empty() && again.view.camera.empty());
  EXPECT_FALSE(again.settings().was_set("camera.vertical_fov"));
}

TEST(ViewerPreset, of_another_scene_leaves_camera_and_lights) {
  const ViewState state = edited_state();
  const Preset preset = parse_preset(R"({"scene": "terrain", "camera": "default", "lights": ["sun"], "technique": "single/pcf",
    "set": {"pcf.size": 9, "light.azimuth": 12, "camera.near": 1, "scene.seed": 9}})",
                                     "other.json");
  const ViewState next = with_preset(state, preset, false);
  EXPECT_TRUE(for_other_scene(state, preset));
  EXPECT_EQ(next.view.scene, "courtyard");
  EXPECT_EQ(next.view.camera, state.view.camera);
  EXPECT_EQ(next.view.lights, state.view.lights);
  EXPECT_EQ(next.settings().block("camera").text("near"), "0.05");
  EXPECT_FALSE(next.settings().was_set("light.azimuth"));
  // Its settings of single lights are of lights that are not there, whatever their names hold.
  const Preset with_lamp =
      parse_preset(R"({"scene": "terrain", "technique": "single/pcf", "set": {"Lamp.7@pcf.size": 9}})", "lamp.json");
  EXPECT_TRUE(with_preset(state, with_lamp, false).settings().lights_named().empty());
  EXPECT_EQ(next.settings().scene_options().at("seed"), 3.0);
  EXPECT_THROW(with_preset(state, parse_preset(R"({"techniques": ["all"]})", "x"), false), Error);
  EXPECT_THROW(with_preset(state, parse_preset(R"({"techniques": ["no/such"]})", "x"), false), Error);
}

TEST(ViewerPreset, the_command_of_a_state_is_the_state) {
  const ViewState state = edited_state();
  const ViewState again = read_command(state.command(state.view.size));
  ViewState expected = state;
  expected.edits.erase("single.size");  // of no technique that is shown: the command would be refused
  expect_same(again, expected, k_names);
}

TEST(ViewState, another_camera_is_another_picture_and_nothing_else) {
  const ViewState state = edited_state();
  ViewState moved = state;
  moved.view.camera = "9,9,9:0,0,0";
  EXPECT_FALSE(moved.same_picture(state));
  EXPECT_TRUE(moved.same_but_camera(state));
  ViewState other = state;
  other.edits["pcf.size"] = "11";
  EXPECT_FALSE(other.same_but_camera(state));
  other = state;
  other.view.lights = {"point:0,3,0"};
  EXPECT_FALSE(other.same_but_camera(state));
}

}  // namespace
}  // namespace gnomon::viewer
