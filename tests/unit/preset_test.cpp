// Presets: reading, merging, writing; errors name file, key and what would be valid.
#include "lab/plan/preset.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace gnomon {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_preset(text, "mine.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "no error";
}

void expect_says(const std::string& text, std::initializer_list<const char*> parts) {
  const std::string error = error_of(text);
  for (const char* part : parts) EXPECT_NE(error.find(part), error.npos) << "'" << part << "' is not in: " << error;
}

TEST(Preset, reads_every_key) {
  const Preset preset =
      parse_preset(R"({"description": "d", "source": "s", "scene": "terrain", "techniques": ["single/hard", "single/pcf"],
    "lights": ["sun"], "camera": "0,1,2:3,4,5", "size": [640, 480], "samples": 4,
    "set": {"single.size": 2048, "cascaded.lambda": 0.5, "pcf.bilinear": false, "cascaded.split": "mixed"}})",
                   "mine.json");
  EXPECT_EQ(preset.name, "mine.json");
  EXPECT_EQ(preset.description, "d");
  EXPECT_EQ(preset.source, "s");
  EXPECT_EQ(preset.scene, "terrain");
  EXPECT_EQ(preset.techniques, (std::vector<std::string>{"single/hard", "single/pcf"}));
  EXPECT_EQ(preset.lights, std::vector<std::string>{"sun"});
  EXPECT_EQ(preset.camera, "0,1,2:3,4,5");
  EXPECT_EQ(*preset.size, uvec2(640, 480));
  EXPECT_EQ(*preset.samples, (SampleCount{4, false}));
  const std::vector<std::pair<std::string, std::string>> set = {
      {"cascaded.lambda", "0.5"}, {"cascaded.split", "mixed"}, {"pcf.bilinear", "false"}, {"single.size", "2048"}};
  EXPECT_EQ(preset.set, set);
}

TEST(Preset, an_empty_one_says_nothing) {
  const Preset preset = parse_preset("{}", "mine.json");
  EXPECT_FALSE(preset.scene || preset.camera || preset.size || preset.samples);
  EXPECT_TRUE(preset.techniques.empty() && preset.lights.empty() && preset.set.empty());
}

TEST(Preset, one_technique_and_up_to_some_samples) {
  const Preset preset = parse_preset(R"({"technique": "single/hard", "samples": "up to 8"})", "mine.json");
  EXPECT_EQ(preset.techniques, std::vector<std::string>{"single/hard"});
  EXPECT_EQ(*preset.samples, (SampleCount{8, true}));
}

TEST(Preset, errors_name_file_key_and_valid_values) {
  expect_says("{\n\"size\": ", {"mine.json:2", "not JSON"});
  expect_says("[]", {"mine.json", "not an object", "techniques"});
  expect_says(R"({"tecnique": "x"})", {"mine.json", "'tecnique'", "technique", "samples"});
  expect_says(R"({"technique": "a", "techniques": ["b"]})", {"mine.json", "both"});
  expect_says(R"({"techniques": [3]})", {"mine.json", "'techniques'", "a list of strings"});
  expect_says(R"({"techniques": []})", {"mine.json", "'techniques'"});
  expect_says(R"({"scene": 3})", {"mine.json", "'scene' is 3", "a string"});
  for (const char* size : {"[0, 3]", "[3]", "\"3x3\"", "[3.5, 3]", "[99999, 3]"}) {
    expect_says(std::string("{\"size\": ") + size + "}", {"mine.json", "'size'", "[width, height]", "16384"});
  }
  for (const char* samples : {"0", "-1", "1.5", "\"8\"", "\"up to\"", "\"up to 0\"", "\"up to 8x\"", "65"}) {
    expect_says(std::string("{\"samples\": ") + samples + "}", {"mine.json", "'samples'", "up to N"});
  }
  expect_says(R"({"set": ["single.size"]})", {"mine.json", "'set'", "cascaded.size"});
  expect_says(R"({"set": {"size": 3}})", {"mine.json", "'size'", "id.key"});
  expect_says(R"({"set": {"single.size": null}})", {"mine.json", "single.size", "null", "a number"});
  EXPECT_THROW(load_preset("no such preset"), Error);
}

TEST(Preset, later_ones_win) {
  Preset base =
      parse_preset(R"({"scene": "terrain", "technique": "single/hard", "size": [10, 20], "set": {"single.size": 64}})", "a");
  overlay(base, parse_preset(R"({"technique": "single/pcf", "samples": 2, "set": {"single.size": 128, "pcf.size": 5}})", "b"));
  EXPECT_EQ(base.scene, "terrain");
  EXPECT_EQ(base.techniques, std::vector<std::string>{"single/pcf"});
  EXPECT_EQ(*base.size, uvec2(10, 20));
  EXPECT_EQ(base.samples->count, 2u);
  EXPECT_NE(preset_text(base).find("\"single.size\": 128"), std::string::npos);
}

TEST(Preset, what_is_written_reads_the_same) {
  for (const Preset& preset : builtin_presets()) {
    const Preset again = parse_preset(preset_text(preset), preset.name);
    EXPECT_EQ(preset_text(again), preset_text(preset)) << preset.name;
    EXPECT_EQ(again.set, preset.set) << preset.name;
    EXPECT_EQ(again.samples, preset.samples) << preset.name;
  }
}

TEST(Preset, built_in_ones_say_what_they_are) {
  EXPECT_GE(builtin_presets().size(), 20u);
  for (const Preset& preset : builtin_presets()) {
    EXPECT_FALSE(preset.description.empty() || preset.source.empty()) << preset.name;
    EXPECT_TRUE(preset.scene.has_value() && preset.techniques.size() == 1) << preset.name;
  }
}

}  // namespace
}  // namespace gnomon
