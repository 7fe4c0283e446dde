// Results in, table, CSV and page out: alignment, escaping, pictures once, and what is refused with file and line.
#include "report/report.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/image.h"
#include "base/temporary_folder.h"
#include "report/html.h"
#include "report/pictures.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;

json minimal(const std::string& technique) {
  return {{"technique", technique},     {"status", "ok"},   {"command", "gnomon compare box -o out"},
          {"scene", {{"name", "box"}}}, {"size", {64, 48}}, {"samples", 1}};
}

json measured(const std::string& technique, double mae, double total) {
  json line = minimal(technique);
  line["settings"] = {{"single", {{"size", 2048}}}};
  line["visibility"]["hard"] = {{"mae", mae},
                                {"rmse", 2 * mae},
                                {"false_shadow", {{"area", 0.004}, {"severity", 0.8}}},
                                {"false_light", {{"area", 0.1}, {"severity", 0.7}}}};
  line["gpu_ms"] = {{"build", 0.75 * total}, {"resolve", 0.25 * total}, {"total", total}};
  line["memory_bytes"] = 16777216;
  return line;
}

json unavailable(const std::string& technique, const std::string& reason) {
  json line = minimal(technique);
  line["status"] = "unavailable";
  line["reason"] = reason;
  return line;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

template <class... Parts>
testing::AssertionResult has(const std::string& text, const Parts&... parts) {
  for (const std::string_view part : {std::string_view(parts)...}) {
    if (text.find(part) == text.npos) return testing::AssertionFailure() << "no '" << part << "' in: " << text.substr(0, 2000);
  }
  return testing::AssertionSuccess();
}

template <class... Parts>
testing::AssertionResult has_none(const std::string& text, const Parts&... parts) {
  for (const std::string_view part : {std::string_view(parts)...}) {
    if (text.find(part) != text.npos) return testing::AssertionFailure() << "'" << part << "' in: " << text.substr(0, 2000);
  }
  return testing::AssertionSuccess();
}

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

class Report : public testing::Test {
 protected:
  Report() { make_folder(folder_ / "images"); }

  void write_lines(const std::vector<json>& lines) {
    std::string text;
    for (const json& line : lines) text += line.dump() + "\n";
    write_file(folder_ / "results.jsonl", text);
  }

  void write_picture(const std::string& name, uint8_t shade) {
    Image8 image(4, 3);
    for (auto& value : image.rgba) value = shade;
    write_png(folder_ / name, image);
  }

  std::string page() {
    write_report(std::vector{folder_}, {});
    return read_text_file(folder_ / "report.html");
  }

  json page_data() {
    const std::string text = page(), open = "id=\"gnomon-data\">";
    const size_t begin = text.find(open) + open.size();
    return json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }

  // The message with which reading the current results fails.
  std::string refusal() {
    try {
      read_results(folder_);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  std::string refusal_of(const std::function<void(json&)>& change) {
    json line = measured("single/pcf", 0.01, 1);
    change(line);
    write_lines({minimal("single/hard"), line});
    return refusal();
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST(TextTable, AlignsItsColumns) {
  // The least error comes first.
  const std::vector<json> results = {measured("cascaded/vsm", 0.12345, 12.5), measured("single/pcf", 0.01, 0.6)};
  EXPECT_EQ(text_table(results),
            "technique     hard mae  false shadow %  false light %  build ms  resolve ms  total ms   MiB\n"
            "single/pcf      0.0100            0.40          10.00     0.450       0.150     0.600  16.0\n"
            "cascaded/vsm    0.1235            0.40          10.00     9.375       3.125    12.500  16.0\n");
}

// Another truth, another winner: figures and order go by the one that is asked for, or else by the first that there is.
TEST(TextTable, GoesByTheTruthThatIsAskedFor) {
  std::vector<json> results = {measured("single/hard", 0.01, 0.6), measured("single/pcf", 0.02, 0.6)};
  results[0]["visibility"]["pixel"] = {{"mae", 0.04}, {"false_shadow", {{"area", 0.31}, {"severity", 0.1}}}};
  results[1]["visibility"]["pixel"] = {{"mae", 0.03}, {"false_shadow", {{"area", 0.21}, {"severity", 0.1}}}};
  const auto by_pixel = lines_of(text_table(results));
  EXPECT_TRUE(has(by_pixel[0], " pixel mae  false shadow %  false light %  hard mae "));
  EXPECT_TRUE(has(by_pixel[1], "single/pcf", "0.0300", "21.00", "0.0200"));
  const auto by_hard = lines_of(text_table(results, "hard"));
  EXPECT_TRUE(has(by_hard[0], " hard mae  false shadow %  false light %  pixel mae "));
  EXPECT_TRUE(has(by_hard[1], "single/hard", "0.0100", "0.40", "0.0400"));
  EXPECT_EQ(text_table(results, "area"), text_table(results)) << "no light here has a size";
}

TEST(TextTable, ShowsAnAreaColumnWhereThereIsOne) {
  std::vector<json> results = {measured("single/pcf", 0.01, 0.6), measured("single/vsm", 0.02, 0.6)};
  results[1]["visibility"]["area"] = {{"mae", 0.0042}};
  const auto lines = lines_of(text_table(results));
  EXPECT_TRUE(has(lines[0], "area mae"));
  EXPECT_TRUE(has(text_table(results), "0.0042"));
}

TEST(TextTable, DashesForWhatWasNotMeasuredAndReasonsForWhatCannotRun) {
  std::vector<json> results = {minimal("single/hard"), unavailable("ray_traced", "no ray tracing"), unavailable("volumes", "")};
  results[0]["visibility"] = {{"hard", {{"mae", nullptr}}}};
  const auto lines = lines_of(text_table(results));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(has(lines[1], "single/hard", "-"));
  EXPECT_TRUE(has_none(lines[1], "nan", "null"));
  EXPECT_EQ(lines[2], "ray_traced   unavailable: no ray tracing");
  EXPECT_EQ(lines[3], "volumes      unavailable: no reason given");
}

TEST(TextTable, GroupsScenesAndNamesTheSettingsThatDiffer) {
  std::vector<json> results = {measured("single/pcf", 0.01, 1), measured("single/pcf", 0.02, 1),
                               measured("single/hard", 0.03, 1)};
  results[1]["settings"]["single"]["size"] = 512;
  json other = measured("single/pcf", 0.04, 1);
  other["scene"]["name"] = "courtyard";
  results.push_back(other);
  const std::string text = text_table(results);
  EXPECT_TRUE(has(text, "\nbox, 64 × 48, 1 sample\n", "\ncourtyard, 64 × 48, 1 sample\n"));
  EXPECT_TRUE(has(text, "\nsingle/pcf single.size=2048  ", "\nsingle/pcf single.size=512   "));
  EXPECT_TRUE(has(text, "\nsingle/hard                  "));
}

TEST(TextTable, ControlCharactersDoNotReachTheTerminal) {
  const std::vector<json> results = {unavailable("evil\x1b[2J", "line\nbreak")};
  const std::string text = text_table(results);
  EXPECT_EQ(text.find('\x1b'), text.npos);
  EXPECT_EQ(count_of(text, "\n"), 2u);
}

TEST(TextTable, OfNothing) { EXPECT_EQ(text_table({}), "no results\n"); }

TEST(Groups, RowsOfOneTechniqueAndSettingsAreNumbered) {
  const std::vector<json> results = {measured("a", 1, 1), measured("a", 2, 1)};
  const auto groups = group_results(results);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].labels, (std::vector<std::string>{"a", "a (2)"}));
}

TEST(Groups, LightsOfOneNameThatDifferAreNotMixed) {
  std::vector<json> results = {measured("a", 1, 1), measured("a", 2, 1)};
  results[0]["lights"] = {{{"name", "sun"}, {"direction", {0, -1, 0}}}};
  results[1]["lights"] = {{{"name", "sun"}, {"direction", {1, -1, 0}}}};
  const auto groups = group_results(results);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_NE(groups[0].title, groups[1].title);
}

TEST(Html, EscapesTextAndJson) {
  EXPECT_EQ(escape_html("<b a='1' c=\"2\">&"), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;");
  const json value = {{"a", "</script><!-- & {{data}}"}};
  const std::string text = script_json(value);
  EXPECT_EQ(text.find_first_of("<>&"), text.npos);
  EXPECT_EQ(json::parse(text), value);
}

TEST(Html, ValuesOfATemplateAreNotSearchedAgain) {
  EXPECT_EQ(fill_template("a {{x}} b {{y}}{{x}}", {{"x", "{{y}}"}, {"y", "2"}}), "a {{y}} b 2{{y}}");
}

TEST(Base64, OfEveryLength) {
  const auto encode = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode("\xff\xfe\xfd"), "//79");
}

TEST_F(Report, ReadsWhatAMeasuringRunWrites) {
  write_lines({measured("single/pcf", 0.01, 1), unavailable("ray_traced", "no ray tracing"), minimal("timed_by_nobody")});
  EXPECT_EQ(read_results(folder_).size(), 3u);
}

TEST_F(Report, RefusesAMissingFileAndAnEmptyOne) {
  EXPECT_TRUE(has(refusal(), "results.jsonl"));
  write_file(folder_ / "results.jsonl", std::string_view("\n"));
  EXPECT_TRUE(has(refusal(), "holds no results"));
  EXPECT_THROW(write_report({}, folder_ / "report.html"), Error);
}

TEST_F(Report, NamesTheLineThatIsNotJson) {
  write_file(folder_ / "results.jsonl", minimal("a").dump() + "\n{\"technique\": \n" + minimal("b").dump() + "\n");
  EXPECT_TRUE(has(refusal(), "results.jsonl:2: not JSON"));
  EXPECT_TRUE(has_none(refusal(), "exception"));
  write_file(folder_ / "results.jsonl", std::string_view("[1, 2]\n"));
  EXPECT_TRUE(has(refusal(), "results.jsonl:1: not a result"));
}

TEST_F(Report, SaysThatTheLastLineIsCutOff) {
  const std::string whole = minimal("a").dump();
  for (size_t length = 1; length < whole.size(); ++length) {
    write_file(folder_ / "results.jsonl", whole + "\n" + whole.substr(0, length));
    ASSERT_TRUE(has(refusal(), "results.jsonl:2: the last line is cut off")) << length;
  }
  write_file(folder_ / "results.jsonl", whole + "\n" + whole);  // whole, only without its newline
  EXPECT_EQ(refusal(), "accepted");
}

TEST_F(Report, NamesTheKeyThatMattersAndIsMissing) {
  for (const char* key : {"technique", "status", "command", "scene", "size", "samples"}) {
    EXPECT_TRUE(has(refusal_of([&](json& line) { line.erase(key); }), "results.jsonl:2:", key)) << key;
  }
}

TEST_F(Report, NamesTheKeyWhoseValueIsOfNoUse) {
  const auto set = [this](const char* pointer, const json& value) {
    return refusal_of([&](json& line) { line[json::json_pointer(pointer)] = value; });
  };
  EXPECT_TRUE(has(set("/visibility/hard/mae", "small"), "'visibility.hard.mae'", "valid: a number"));
  EXPECT_TRUE(has(set("/gpu_ms", 1), "'gpu_ms' is 1; valid: an object"));
  EXPECT_TRUE(has(set("/status", "fine"), "valid: ok, unavailable"));
  EXPECT_TRUE(has(set("/size", {64}), "'size'"));
  EXPECT_TRUE(has(set("/size", {0, 64}), "'size'"));
  EXPECT_TRUE(has(set("/samples", 0), "'samples'"));
  EXPECT_TRUE(has(set("/passes", json::array({{{"median_ms", 1}}})), "'passes.0' has no name"));
  EXPECT_TRUE(has(set("/passes", json::array({{{"name", "a"}, {"median_ms", "x"}}})), "'passes.0.median_ms'"));
  EXPECT_EQ(set("/visibility/hard/mae", nullptr), "accepted");
  EXPECT_EQ(set("/a_key_of_a_later_version", 1), "accepted");
}

TEST_F(Report, NamesResultsAndPictureWhereOneIsMissing) {
  EXPECT_TRUE(has(refusal_of([](json& line) {
                    line["images"] = {{"error", {{"hard", "images/lost.png"}}}};
                  }),
                  "results.jsonl:2", "images.error.hard", "images/lost.png", "missing"));
}

TEST_F(Report, TakesNoPicturesFromOutsideItsFolder) {
  for (const char* name : {"../secret.png", "images/../../secret.png", "/etc/hostname"}) {
    EXPECT_TRUE(has(refusal_of([&](json& line) { line["images"] = {{"shaded", name}}; }), "outside")) << name;
  }
}

TEST_F(Report, RefusesAPictureThatIsNoPng) {
  write_file(folder_ / "images/a.png", std::string_view("hello"));
  json line = minimal("a");
  line["images"] = {{"shaded", "images/a.png"}};
  write_lines({line});
  try {
    page();
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_TRUE(has(error.what(), "results.jsonl:1", "a.png", "not a PNG"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
}

TEST_F(Report, EmbedsEachPictureOnce) {
  write_picture("images/reference.png", 10);
  write_picture("images/copy_of_reference.png", 10);
  write_picture("images/a.png", 20);
  write_picture("images/b.png", 30);
  json a = minimal("a"), b = minimal("b");
  a["images"] = {{"shaded", "images/a.png"}, {"reference", {{"hard", "images/reference.png"}}}};
  b["images"] = {{"shaded", "images/b.png"}, {"reference", {{"hard", "images/copy_of_reference.png"}}}};
  write_lines({a, b});
  const json data = page_data();
  EXPECT_EQ(data["pictures"].size(), 3u);
  const json& rows = data["groups"][0]["rows"];
  EXPECT_EQ(rows[0]["images"]["reference"], rows[1]["images"]["reference"]);
  EXPECT_NE(rows[0]["images"]["shaded"], rows[1]["images"]["shaded"]);
}

TEST_F(Report, StringsCannotLeaveTheirPlace) {
  const std::string evil = "</script><script>alert(1)</script><!--{{js}}";
  json line = measured(evil, 0.01, 1);
  line["scene"]["name"] = evil;
  line["command"] = evil;
  write_lines({line, unavailable("b", evil)});
  EXPECT_EQ(page_data()["groups"][0]["rows"][0]["command"], evil);
  const std::string text = page();
  EXPECT_EQ(count_of(text, "alert(1)</script>"), 0u);
  EXPECT_EQ(count_of(text, "<script"), 3u);
  EXPECT_EQ(count_of(text, "</script"), 3u);
  EXPECT_EQ(count_of(text, "<!--"), 0u);
}

TEST_F(Report, IsOneFileThatLoadsNothing) {
  write_lines({measured("a", 0.01, 1)});
  const std::string text = page();
  EXPECT_TRUE(has(text, "default-src 'none'", "Chart.js v"));
  EXPECT_EQ(count_of(text, "<script src"), 0u);
  EXPECT_EQ(count_of(text, "rel=\"stylesheet\""), 0u);
  EXPECT_EQ(text, page()) << "the same results give the same page";
}

TEST_F(Report, JoinsFoldersAndWritesWhereAsked) {
  write_lines({measured("a", 0.01, 1)});
  const auto second = folder_ / "second";
  make_folder(second);
  write_file(second / "results.jsonl", measured("b", 0.02, 1).dump() + "\n");
  write_report(std::vector{folder_, second}, folder_ / "both.html");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
  EXPECT_TRUE(has(read_text_file(folder_ / "both.html"), "\"label\":\"b\""));
}

TEST_F(Report, CsvQuotesAndKeepsFullPrecision) {
  json line = measured("a", 0.1234567890123, 1);
  line["command"] = "gnomon compare \"my scene\", twice";
  line["artefacts"] = {{"acne", 0.25}};
  json other = unavailable("b", "two\nlines");
  other["settings"] = {{"vsm", {{"blur", 3}}}};
  write_lines({line, other});
  write_csv(std::vector{folder_}, folder_ / "results.csv");
  const std::string text = read_text_file(folder_ / "results.csv");
  EXPECT_TRUE(has(text, "0.1234567890123,", "\"gnomon compare \"\"my scene\"\", twice\"", "\"two\nlines\""));
  const auto lines = lines_of(text);
  EXPECT_TRUE(lines[0].ends_with(",command,artefacts.acne,single.size,vsm.blur")) << lines[0];
  EXPECT_TRUE(lines[1].ends_with(",0.25,2048,")) << lines[1];
  EXPECT_TRUE(lines.back().ends_with(",,,3")) << lines.back();
}

// The row of a line whose every value differs from every other: a column that holds another one's value shows.
TEST_F(Report, EveryCsvColumnHoldsTheValueOfItsName) {
  struct Expected {
    const char *title, *pointer;
    json value;
  };
  const std::vector<Expected> columns = {
      {"scene", "/scene/name", "a scene"},
      {"scene_hash", "/scene/hash", "0123abcd"},
      {"triangles", "/scene/triangles", 1001},
      {"camera", "/camera/name", "a camera"},
      {"width", "/size/0", 64},
      {"height", "/size/1", 48},
      {"samples", "/samples", 4},
      {"device", "/device/name", "a device"},
      {"driver", "/device/driver", "a driver"},
      {"driver_version", "/device/driver_version", "9.8.7"},
      {"gnomon_version", "/gnomon/version", "1.2.3"},
      {"gnomon_commit", "/gnomon/commit", "fedc"},
      {"technique", "/technique", "single/pcf"},
      {"status", "/status", "ok"},
      {"reason", "/reason", "a reason"},
      {"hard_mae", "/visibility/hard/mae", 0.0101},
      {"hard_rmse", "/visibility/hard/rmse", 0.0102},
      {"hard_bias", "/visibility/hard/bias", -0.0103},
      {"hard_false_shadow_area", "/visibility/hard/false_shadow/area", 0.0104},
      {"hard_false_shadow_severity", "/visibility/hard/false_shadow/severity", 0.0105},
      {"hard_false_light_area", "/visibility/hard/false_light/area", 0.0106},
      {"hard_false_light_severity", "/visibility/hard/false_light/severity", 0.0107},
      {"hard_receivers", "/visibility/hard/receivers", 1008},
      {"area_mae", "/visibility/area/mae", 0.0201},
      {"area_rmse", "/visibility/area/rmse", 0.0202},
      {"area_bias", "/visibility/area/bias", -0.0203},
      {"area_false_shadow_area", "/visibility/area/false_shadow/area", 0.0204},
      {"area_false_shadow_severity", "/visibility/area/false_shadow/severity", 0.0205},
      {"area_false_light_area", "/visibility/area/false_light/area", 0.0206},
      {"area_false_light_severity", "/visibility/area/false_light/severity", 0.0207},
      {"area_receivers", "/visibility/area/receivers", 1009},
      {"pixel_mae", "/visibility/pixel/mae", 0.0211},
      {"pixel_rmse", "/visibility/pixel/rmse", 0.0212},
      {"pixel_bias", "/visibility/pixel/bias", -0.0213},
      {"pixel_false_shadow_area", "/visibility/pixel/false_shadow/area", 0.0214},
      {"pixel_false_shadow_severity", "/visibility/pixel/false_shadow/severity", 0.0215},
      {"pixel_false_light_area", "/visibility/pixel/false_light/area", 0.0216},
      {"pixel_false_light_severity", "/visibility/pixel/false_light/severity", 0.0217},
      {"pixel_receivers", "/visibility/pixel/receivers", 1010},
      {"image_rmse", "/image/rmse", 0.0301},
      {"image_psnr", "/image/psnr", 30.25},
      {"build_ms", "/gpu_ms/build", 1.5},
      {"resolve_ms", "/gpu_ms/resolve", 2.5},
      {"total_ms", "/gpu_ms/total", 4.25},
      {"frame_ms", "/timing/frame_ms", 5.5},
      {"sum_of_passes_ms", "/timing/sum_of_passes_ms", 6.5},
      {"timing_mode", "/timing/mode", "measure"},
      {"timing_clock", "/timing/clock", "a clock"},
      {"memory_bytes", "/memory_bytes", 16777216},
      {"hard_reference", "/reference/hard/kind", "embree"},
      {"hard_reference_samples", "/reference/hard/samples", 1},
      {"hard_reference_confidence", "/reference/hard/confidence", 0.0401},
      {"area_reference", "/reference/area/kind", "pipeline"},
      {"area_reference_samples", "/reference/area/samples", 256},
      {"area_reference_confidence", "/reference/area/confidence", 0.0402},
      {"pixel_reference", "/reference/pixel/kind", "a tracer"},
      {"pixel_reference_samples", "/reference/pixel/samples", 25},
      {"pixel_reference_rays", "/reference/pixel/rays", 5},
      {"pixel_reference_confidence", "/reference/pixel/confidence", 0.0403},
      {"pixel_uncovered", "/reference/pixel/uncovered", 0.0404},
      {"command", "/command", "gnomon compare"},
  };
  json line = {{"size", {0, 0}}};
  for (const Expected& column : columns) line[json::json_pointer(column.pointer)] = column.value;
  line["artefacts"] = {{"acne", 0.0501}, {"light_leak", 0.0502}};
  line["settings"] = {{"single", {{"size", 2048}}}, {"pcf", {{"taps", 17}}}};
  write_lines({line});
  write_csv(std::vector{folder_}, folder_ / "results.csv");

  // No value holds a comma or a quote.
  const auto cells_of = [](const std::string& row) {
    std::vector<std::string> cells(1);
    for (const char c : row) {
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    return cells;
  };
  const auto rows = lines_of(read_text_file(folder_ / "results.csv"));
  ASSERT_EQ(rows.size(), 2u);
  const auto titles = cells_of(rows[0]), values = cells_of(rows[1]);
  ASSERT_EQ(titles.size(), values.size());
  std::map<std::string, std::string> row;
  for (size_t i = 0; i < titles.size(); ++i) EXPECT_TRUE(row.emplace(titles[i], values[i]).second) << titles[i] << " twice";
  for (const auto& [title, pointer, value] : columns) {
    EXPECT_EQ(row[title], value.is_string() ? value.get<std::string>() : value.dump()) << title;
  }
  EXPECT_EQ(row["artefacts.acne"], "0.0501");
  EXPECT_EQ(row["artefacts.light_leak"], "0.0502");
  EXPECT_EQ(row["single.size"], "2048");
  EXPECT_EQ(row["pcf.taps"], "17");
  EXPECT_EQ(titles.size(), columns.size() + 4) << "a column that this test does not know: " << rows[0];
}

}  // namespace
}  // namespace gnomon
