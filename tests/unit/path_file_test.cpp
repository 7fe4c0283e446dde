// Paths of cameras and suns as files.
#include "lab/view/path_file.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace gnomon {
namespace {

TEST(PathFile, what_is_written_reads_the_same) {
  const CameraPath path{"a \"walk\"",
                        {{0.0, {0.1f, 1e-7f, 3e8f}, {0, 0, -1}}, {0.1, {1, 2, 3}, {4, 5, 6}}, {1.7, {1, 2, 4}, {4, 5, 6}}}};
  const Recording recording = parse_recording(recording_text({path, std::nullopt}), "mine.json");
  EXPECT_FALSE(recording.sun);
  ASSERT_TRUE(recording.camera);
  const CameraPath& again = *recording.camera;
  EXPECT_EQ(again.name, path.name);
  ASSERT_EQ(again.keys.size(), path.keys.size());
  for (size_t i = 0; i < path.keys.size(); ++i) {
    EXPECT_EQ(again.keys[i].time_s, path.keys[i].time_s);
    EXPECT_EQ(again.keys[i].eye, path.keys[i].eye);
    EXPECT_EQ(again.keys[i].target, path.keys[i].target);
  }
}

TEST(PathFile, suns_read_the_same_alone_and_beside_a_camera) {
  const CameraPath walk{"walk", {{0.0, {0, 0, 0}, {0, 0, -1}}, {1.0, {1, 0, 0}, {0, 0, -1}}}};
  const RecordedSun path{"evening",
                         {{0.0, {glm::normalize(vec3(0.3f, -0.6f, 0.2f)), {1, 0.9f, 0.7f}, 3.1f}},
                          {0.25, {glm::normalize(vec3(0.3f, -0.59f, 0.21f)), {1, 0.5f, 0}, 1e-3f}},
                          {9.0, {{0, -1, 0}, {0, 0, 0}, 0.0f}}}};
  for (const bool beside : {false, true}) {
    const Recording recording =
        parse_recording(recording_text({beside ? std::optional(walk) : std::nullopt, path}), "mine.json");
    EXPECT_EQ(recording.camera.has_value(), beside);
    ASSERT_TRUE(recording.sun);
    EXPECT_EQ(recording.sun->name, beside ? "walk" : "evening");
    ASSERT_EQ(recording.sun->keys.size(), path.keys.size());
    for (size_t i = 0; i < path.keys.size(); ++i) {
      const SunKey &key = recording.sun->keys[i], &expected = path.keys[i];
      EXPECT_EQ(key.time_s, expected.time_s);
      EXPECT_LT(glm::length(key.state.direction - expected.state.direction), 2e-6f);
      EXPECT_EQ(key.state.colour, expected.state.colour);
      EXPECT_EQ(key.state.intensity, expected.state.intensity);
    }
  }
}

TEST(PathFile, errors_name_file_and_key) {
  const auto expect_says = [](const char* text, const char* part) {
    try {
      parse_recording(text, "mine.json");
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::usage);
      EXPECT_NE(std::string(error.what()).find("mine.json"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  const std::string begin = R"({"name": "a", "keys": [{"time": 0, "eye": [0,0,0], "target": [0,0,1]}, )";
  expect_says("{", "not JSON");
  expect_says("{}", "'name'");
  expect_says(R"({"name": "a"})", "'keys' (of a camera) nor 'sun'");
  expect_says(R"({"name": "a", "keys": []})", "two keys");
  expect_says((begin + R"({"time": 0, "eye": [0,0,0], "target": [0,0,1]}]})").c_str(), "keys[1]");
  expect_says((begin + R"({"time": 1, "eye": [0,0], "target": [0,0,1]}]})").c_str(), "[x, y, z]");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1e99], "target": [0,0,1]}]})").c_str(), "'eye'");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1]}]})").c_str(), "'target'");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1], "target": [0,0,1]}]})").c_str(), "another point");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1], "target": [0,0,2], "up": 1}]})").c_str(), "'up'");
  const auto sun = [](const char* first, const char* second) {
    const std::string rest = R"("colour": [1,1,1], "intensity": 1})";
    return R"({"name": "a", "sun": [{"time": 0, )" + std::string(first) + rest + R"(, {"time": 1, )" + second + rest + "]}";
  };
  const char* const good = R"("azimuth": 10, "elevation": 20, )";
  EXPECT_NO_THROW(parse_recording(sun(good, good), "mine.json"));
  expect_says(R"({"name": "a", "sun": 3})", "'sun': valid: a list of two keys");
  expect_says(sun(R"("azimuth": 10, )", good).c_str(), "sun[0]: no key 'elevation'");
  expect_says(sun(good, R"("azimuth": 10, "elevation": 91, )").c_str(), "sun[1]: 'elevation' is 91; valid: -90 to 90");
  expect_says(sun(good, R"("azimuth": "north", "elevation": 9, )").c_str(), "'azimuth'");
  expect_says(sun(good, R"("azimuth": 190, "elevation": -20, )").c_str(), "sun[1]: opposite");
  expect_says(R"({"name": "a", "sun": [{"time": 0, "azimuth": 1, "elevation": 1, "colour": [1, -1, 1], "intensity": 1}, {}]})",
              "'colour'");
  expect_says(R"({"name": "a", "sun": [{"time": 0, "azimuth": 1, "elevation": 1, "colour": [1, 1, 1], "intensity": -1}, {}]})",
              "'intensity'");
  expect_says(R"({"name": "a", "sun": [{"time": 2, "azimuth": 1, "elevation": 1, "colour": [1, 1, 1], "intensity": 1}, {}]})",
              "'time'");
}

}  // namespace
}  // namespace gnomon
