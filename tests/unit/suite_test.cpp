// Suites: reading, blocks, quantities, ratios.
#include <nlohmann/json.hpp>

#include "lab/plan/suite.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "lab/plan/quantity.h"

namespace gnomon {
namespace {

using nlohmann::json;

constexpr const char* k_suite =
    R"({"description": "d", "source": "s", "defaults": {"scene": "terrain", "set": {"single.size": 64}},
  "runs": [{"name": "a", "technique": "single/hard"}, {"name": "b", "technique": "single/pcf", "scene": "courtyard", "set": {"single.size": 128}},
           {"name": "c", "kernel": "copy", "texels": 256}, {"name": "d", "technique": "single/hard"}, {"name": "e", "technique": "single/hard"}],
  "rows": [{"name": "b over a", "of": "technique", "numerator": "b", "denominator": "a", "published": [1.5, 2], "goal": 1.2},
           {"name": "d alone", "of": "ms:depth", "run": "d", "published": 1.19},
           {"name": "same", "masks": ["c", "e"]}]})";

json line_of(const char* run, double build, double resolve, double frame) {
  json line = {{"bench", {{"run", run}}}, {"timing", {{"frame_ms", frame}, {"record_ms", 0.25}}}, {"memory_bytes", 4096}};
  line["gpu_ms"] = {{"build", build}, {"resolve", resolve}, {"total", build + resolve}};
  line["passes"] = {{{"name", "single/depth"}, {"median_ms", build / 2}, {"draws", 3}, {"triangles", 100}},
                    {{"name", "x/depth"}, {"median_ms", build / 2}, {"draws", 4}, {"triangles", 200}},
                    {{"name", "single/hard/resolve"}, {"median_ms", resolve}, {"draws", 0}, {"triangles", 0}}};
  return line;
}

TEST(Suite, runs_take_defaults_and_their_own) {
  const Suite suite = parse_suite(k_suite, "mine.json");
  ASSERT_EQ(suite.runs.size(), 5u);
  EXPECT_EQ(suite.runs[0].view.scene, "terrain");
  EXPECT_EQ(suite.runs[1].view.scene, "courtyard");
  EXPECT_EQ(suite.runs[1].view.set.back(), std::make_pair(std::string("single.size"), std::string("128")));
  EXPECT_EQ(suite.runs[2].kernel, "copy");
  EXPECT_EQ(suite.runs[2].texels, 256u);
  EXPECT_EQ(suite.rows[1].kind, SuiteRow::Kind::figure);
  EXPECT_EQ(suite.rows[2].kind, SuiteRow::Kind::masks);
}

TEST(Suite, runs_that_rows_connect_are_side_by_side) {
  const std::vector<std::vector<size_t>> expected = {{0, 1}, {2, 4}, {3}};
  EXPECT_EQ(side_by_side(parse_suite(k_suite, "mine.json")), expected);
}

TEST(Suite, only_some_rows) {
  Suite suite = parse_suite(k_suite, "mine.json");
  keep_only(suite, {"b over a", "d"});
  ASSERT_EQ(suite.runs.size(), 3u);
  EXPECT_EQ(suite.runs[2].name, "d");
  ASSERT_EQ(suite.rows.size(), 1u);
  EXPECT_EQ(suite.rows[0].name, "b over a");
  EXPECT_THROW(keep_only(suite, {"no such row"}), Error);
}

TEST(Suite, errors_name_the_place) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      parse_suite(text, "mine.json");
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string run = R"({"name": "a", "scene": "terrain", "technique": "single/hard"})";
  const auto with_row = [&](const std::string& row) { return error_of("{\"runs\": [" + run + "], \"rows\": [" + row + "]}"); };
  EXPECT_NE(error_of("{}").find("'runs'"), std::string::npos);
  EXPECT_NE(error_of(R"({"runs": [{"name": "a"}]})").find("runs[0]"), std::string::npos);
  EXPECT_NE(error_of(R"({"runs": [{"name": "a", "scene": "terrain", "cats": 3}]})").find("'cats'"), std::string::npos);
  EXPECT_NE(error_of("{\"runs\": [" + run + "," + run + "]}").find("second run 'a'"), std::string::npos);
  EXPECT_NE(with_row(R"({"name": "r", "of": "cats", "run": "a"})").find("technique, build"), std::string::npos);
  EXPECT_NE(with_row(R"({"name": "r", "of": "frame", "run": "b"})").find("no run 'b'; valid: a"), std::string::npos);
  EXPECT_NE(with_row(R"({"name": "r", "of": "frame", "numerator": "a"})").find("'denominator'"), std::string::npos);
  EXPECT_NE(with_row(R"({"name": "r", "of": "frame", "run": "a", "published": [2, 1]})").find("[from, to]"), std::string::npos);
}

TEST(Suite, built_in_ones_are_complete) {
  EXPECT_GE(builtin_suites().size(), 5u);
  for (const Suite& suite : builtin_suites()) {
    EXPECT_FALSE(suite.description.empty() || suite.source.empty() || suite.rows.empty()) << suite.name;
  }
}

TEST(Quantity, of_a_line) {
  const json line = line_of("a", 2.0, 1.0, 5.0);
  EXPECT_EQ(quantity(line, "frame"), 5.0);
  EXPECT_EQ(quantity(line, "technique"), 3.0);
  EXPECT_EQ(quantity(line, "record"), 0.25);
  EXPECT_EQ(quantity(line, "memory"), 4096.0);
  EXPECT_EQ(quantity(line, "ms:depth"), 2.0);
  EXPECT_EQ(quantity(line, "draws:depth"), 7.0);
  EXPECT_EQ(quantity(line, "triangles:single/depth"), 100.0);
  EXPECT_EQ(quantity(line, "ms:cats"), std::nullopt);
  EXPECT_EQ(quantity(json{{"status", "unavailable"}}, "frame"), std::nullopt);
  EXPECT_FALSE(is_quantity("ms:"));
  EXPECT_FALSE(is_quantity("cats"));
}

TEST(Quantity, ratio_against_published_and_goal) {
  const Suite suite = parse_suite(k_suite, "mine.json");
  const std::vector<json> lines = {line_of("a", 2.0, 1.0, 5.0), line_of("b", 3.0, 1.5, 6.0), line_of("d", 2.0, 1.0, 5.0)};
  const json ratio = evaluate_row(suite.rows[0], lines);
  EXPECT_EQ(ratio["kind"], "ratio");
  EXPECT_EQ(ratio["numerator"], 4.5);
  EXPECT_EQ(ratio["denominator"], 3.0);
  EXPECT_EQ(ratio["value"], 1.5);
  EXPECT_EQ(ratio["also"], json({{"of", "frame"}, {"value", 1.2}}));
  EXPECT_EQ(ratio["published"], json({1.5, 2.0}));
  EXPECT_EQ(ratio["met"], false);
  const json figure = evaluate_row(suite.rows[1], lines);
  EXPECT_EQ(figure["value"], 2.0);
  EXPECT_EQ(figure["unit"], "ms");
  EXPECT_TRUE(figure["met"].is_null());
}

TEST(Quantity, what_is_missing_is_null) {
  const Suite suite = parse_suite(k_suite, "mine.json");
  const json ratio = evaluate_row(suite.rows[0], {line_of("b", 3.0, 1.5, 6.0)});
  EXPECT_EQ(ratio["numerator"], 4.5);
  EXPECT_TRUE(ratio["denominator"].is_null() && ratio["value"].is_null() && ratio["met"].is_null());
  EXPECT_TRUE(evaluate_row(suite.rows[0], {line_of("a", 0.0, 0.0, 0.0), line_of("b", 3.0, 1.5, 6.0)})["value"].is_null());
}

TEST(Quantity, masks_are_equal_or_not) {
  const Suite suite = parse_suite(k_suite, "mine.json");
  std::vector<json> lines = {line_of("c", 1, 1, 1), line_of("e", 1, 1, 1)};
  EXPECT_TRUE(evaluate_row(suite.rows[2], lines)["met"].is_null());
  for (json& line : lines) line["bench"]["mask_hash"] = "0a";
  EXPECT_EQ(evaluate_row(suite.rows[2], lines)["met"], true);
  lines[1]["bench"]["mask_hash"] = "0b";
  EXPECT_EQ(evaluate_row(suite.rows[2], lines)["met"], false);
}

}  // namespace
}  // namespace gnomon
