// Camera paths as files.
#include "lab/path_file.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace gnomon {
namespace {

TEST(PathFile, what_is_written_reads_the_same) {
  const CameraPath path{"a \"walk\"", {{0.0, {0.1f, 1e-7f, 3e8f}, {0, 0, -1}}, {0.1, {1, 2, 3}, {4, 5, 6}}, {1.7, {1, 2, 4}, {4, 5, 6}}}};
  const CameraPath again = parse_camera_path(camera_path_text(path), "mine.json");
  EXPECT_EQ(again.name, path.name);
  ASSERT_EQ(again.keys.size(), path.keys.size());
  for (size_t i = 0; i < path.keys.size(); ++i) {
    EXPECT_EQ(again.keys[i].time_s, path.keys[i].time_s);
    EXPECT_EQ(again.keys[i].eye, path.keys[i].eye);
    EXPECT_EQ(again.keys[i].target, path.keys[i].target);
  }
}

TEST(PathFile, errors_name_file_and_key) {
  const auto expect_says = [](const char* text, const char* part) {
    try {
      parse_camera_path(text, "mine.json");
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
  expect_says(R"({"name": "a"})", "'keys'");
  expect_says(R"({"name": "a", "keys": []})", "two keys");
  expect_says((begin + R"({"time": 0, "eye": [0,0,0], "target": [0,0,1]}]})").c_str(), "keys[1]");
  expect_says((begin + R"({"time": 1, "eye": [0,0], "target": [0,0,1]}]})").c_str(), "[x, y, z]");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1e99], "target": [0,0,1]}]})").c_str(), "'eye'");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1]}]})").c_str(), "'target'");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1], "target": [0,0,1]}]})").c_str(), "another point");
  expect_says((begin + R"({"time": 1, "eye": [0,0,1], "target": [0,0,2], "up": 1}]})").c_str(), "'up'");
}

}  // namespace
}  // namespace gnomon
