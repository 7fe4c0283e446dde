// A result is replaced as a whole: whatever a run is stopped in, the folder holds the old result or the new one, never both.
#include "base/result_folder.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "base/file.h"
#include "scene_files.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* k_keys[] = {"technique", "settings"};

json line(const std::string& technique, int size = 1) {
  return {{"technique", technique},
          {"settings", {{"size", size}, {"third", 1.0f / 3.0f}}},
          {"status", "ok"},
          {"images", {{"mask", "images/" + technique + ".png"}}}};
}

std::set<std::string> files(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).string());
  }
  return names;
}

void measure(ResultFolder& run, const json& result) {
  make_folder(run.unfinished() / "images");
  write_file(run.unfinished() / result["images"]["mask"].get<std::string>(), std::string_view("picture"));
  run.add(result);
}

void finish(ResultFolder& run) {
  run.complete();
  write_file(run.unfinished() / "report.html", std::string_view("page"));
  run.publish();
}

class ResultFolders : public testing::Test {
 private:
  test_files::Folder folder_;

 protected:
  const fs::path out = folder_.path() / "out";
};

TEST_F(ResultFolders, AFinishedRunReplacesTheFormerOne) {
  for (const char* name : {"a", "b"}) {
    ResultFolder run(out, false);
    measure(run, line(name));
    finish(run);
    EXPECT_EQ(files(out), (std::set<std::string>{"results.jsonl", "report.html", std::string("images/") + name + ".png"}));
  }
  EXPECT_FALSE(unfinished_run(out));
}

TEST_F(ResultFolders, ARunWithoutALineLeavesNothing) {
  { const ResultFolder run(out, false); }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(ResultFolders, KeepsWhatIsEqualAndStillThere) {
  {
    ResultFolder run(out, false);
    for (const char* name : {"a", "b", "c"}) measure(run, line(name));
    fs::remove(run.unfinished() / "images/c.png");
  }
  EXPECT_EQ(unfinished_run(out)->lines, 3u);
  ResultFolder run(out, true);
  EXPECT_TRUE(run.take_kept(line("a"), k_keys));
  EXPECT_FALSE(run.take_kept(line("a"), k_keys)) << "handed out twice";
  EXPECT_FALSE(run.take_kept(line("b", 2), k_keys)) << "another setting";
  EXPECT_FALSE(run.take_kept(line("c"), k_keys)) << "its picture is gone";
  run.add(line("a"));
  EXPECT_EQ(unfinished_run(out)->lines, 3u) << "what nobody has asked for yet is not lost";
  finish(run);
  EXPECT_EQ(files(out), (std::set<std::string>{"results.jsonl", "report.html", "images/a.png"}));
}

TEST_F(ResultFolders, OneRunAtATime) {
  const ResultFolder run(out, false);
  EXPECT_THROW(ResultFolder(out, false), Error);
}

// Each state that a replacement passes through, by hand.
TEST_F(ResultFolders, AReplacementIsCompletedFromAnyStep) {
  const std::set<std::string> whole = {"results.jsonl", "report.html", "images/new_a.png", "images/both.png"};
  for (int step = 0; step < 6; ++step) {
    fs::remove_all(out);
    const fs::path from = out / "gnomon.replacing";
    make_folder(out / "images");
    make_folder(from / "images");
    write_file(out / "results.jsonl", line("old").dump() + "\n" + line("both").dump() + "\n");
    for (const char* name : {"images/old.png", "images/both.png", "report.html"})
      write_file(out / name, std::string_view("old"));
    write_file(from / "results.jsonl", line("new_a").dump() + "\n" + line("both").dump() + "\n");
    for (const char* name : {"images/new_a.png", "images/both.png", "report.html"})
      write_file(from / name, std::string_view("new"));
    if (step > 0) fs::remove(out / "report.html"), fs::remove(out / "images/old.png");
    if (step > 1) fs::remove(out / "images/both.png"), fs::remove(out / "results.jsonl");
    if (step > 2) fs::rename(from / "images/both.png", out / "images/both.png");
    if (step > 3)
      fs::rename(from / "images/new_a.png", out / "images/new_a.png"),
          fs::rename(from / "results.jsonl", out / "results.jsonl");
    if (step > 4) fs::rename(from / "report.html", out / "report.html");
    settle_results(out);
    EXPECT_EQ(files(out), whole) << step;
    EXPECT_EQ(read_text_file(out / "images/both.png"), "new") << step;
    EXPECT_EQ(read_text_file(out / "report.html"), "new") << step;
  }
}

TEST_F(ResultFolders, RemovesNoFileOutsideItsPictures) {
  make_folder(out / "images");
  write_file(out / "notes.txt", std::string_view("mine"));
  write_file(out / "images/mine.png", std::string_view("mine"));
  json evil = line("x");
  evil["images"] = {{"a", "notes.txt"}, {"b", "images/../notes.txt"}, {"c", "/etc/hostname"}, {"d", "images"}};
  write_file(out / "results.jsonl", evil.dump() + "\nnot a line\n[1]\n");
  ResultFolder run(out, false);
  measure(run, line("a"));
  finish(run);
  EXPECT_EQ(files(out),
            (std::set<std::string>{"results.jsonl", "report.html", "images/a.png", "images/mine.png", "notes.txt"}));
}

}  // namespace
}  // namespace gnomon
