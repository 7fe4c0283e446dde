// Names as exporters write them, and that the exact one goes before any other.
#include "scene/file_finder.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class FileFinding : public ::testing::Test {
 protected:
  void have(const fs::path& path) {
    make_folder((folder_ / path).parent_path());
    write_file(folder_ / path, "x");
  }
  // Relative to the folder; "" where nothing is found.
  std::string find(const std::string& name) {
    const auto found = finder_->find(name, folders_);
    return found ? fs::relative(*found, folder_).string() : "";
  }
  std::string find_exactly(const std::string& name) {
    const auto found = finder_->find_exactly(name, folders_);
    return found ? fs::relative(*found, folder_).string() : "";
  }
  std::string said() {
    testing::internal::CaptureStderr();
    finder_.emplace("scene.obj");
    return testing::internal::GetCapturedStderr();
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  std::vector<fs::path> folders_ = {folder_};
  std::optional<FileFinder> finder_{std::in_place, "scene.obj"};
};

TEST_F(FileFinding, ExactNamesAreNoGuess) {
  have("maps/a.png");
  have("A.png"), have("a.png");
  EXPECT_EQ(find("maps/a.png"), "maps/a.png");
  EXPECT_EQ(find("maps\\a.png"), "maps/a.png");
  EXPECT_EQ(find("./maps//a.png"), "maps/a.png");
  EXPECT_EQ(find(" \"a.png\" "), "a.png");
  EXPECT_EQ(find("A.png"), "A.png") << "the one spelled so";
  EXPECT_EQ(find("a.png"), "a.png");
  EXPECT_EQ(find((folder_ / "a.png").string()), "a.png") << "an absolute path of this machine";
  EXPECT_EQ(said(), "");
}

TEST_F(FileFinding, CaseOfLettersInEveryStep) {
  have("Maps/red.png");
  have("b.PNG"), have("B.png");
  EXPECT_EQ(find("mAPS/Red.PNG"), "Maps/red.png");
  EXPECT_EQ(find_exactly("mAPS/Red.PNG"), "");
  EXPECT_EQ(find("b.png"), "B.png") << "of several always the same";
}

TEST_F(FileFinding, PathsOfAnotherMachine) {
  have("textures/wood.png"), have("wood.png"), have("stone.png");
  EXPECT_EQ(find("C:\\Users\\me\\model\\textures\\wood.png"), "textures/wood.png") << "the longest end of the path";
  EXPECT_EQ(find("/home/me/Textures/WOOD.PNG"), "textures/wood.png");
  EXPECT_EQ(find("D:/x/stone.png"), "stone.png");
  EXPECT_EQ(find("../elsewhere/stone.png"), "stone.png");
}

TEST_F(FileFinding, FoldersInTheirOrder) {
  have("lib/a.png"), have("a.png"), have("lib/b.PNG"), have("b.png");
  folders_ = {folder_ / "lib", folder_};
  EXPECT_EQ(find("a.png"), "lib/a.png");
  EXPECT_EQ(find("b.png"), "b.png") << "an exact name goes before another case of letters";
  folders_ = {fs::path(), folder_};
  EXPECT_EQ(find("a.png"), "a.png");
  folders_ = {fs::path()};
  EXPECT_EQ(find("a.png"), "") << "no folder: nothing";
}

TEST_F(FileFinding, OnlyFilesAreFound) {
  make_folder(folder_ / "folder.png");
  have("x/y.png");
  for (const std::string name : {"folder.png", "Folder.PNG", "", " ", "\"\"", ".", "..", "/", "x", "/dev/zero", "absent.png"})
    EXPECT_EQ(find(name), "") << name;
  EXPECT_EQ(find(std::string("x/y.png\0z", 9)), "");
  std::string slashes(100000, '/');
  slashes += 'q';
  EXPECT_EQ(find(slashes), "");
  std::string deep;
  for (int i = 0; i < 10000; ++i) deep += "d/";
  EXPECT_EQ(find(deep + "y.png"), "");
}

TEST_F(FileFinding, GuessesAreSaidOnceForAll) {
  have("red.png"), have("green.png");
  for (int i = 0; i < 3; ++i) find("Red.PNG");
  const std::string one = said();
  EXPECT_NE(one.find("scene.obj: 1 file was found"), std::string::npos) << one;
  EXPECT_NE(one.find("red.png for 'Red.PNG'"), std::string::npos) << one;
  find("Red.PNG"), find("C:\\green.png");
  const std::string two = said();
  EXPECT_NE(two.find("2 files were found"), std::string::npos) << two;
  EXPECT_EQ(std::count(two.begin(), two.end(), '\n'), 1);
}

}  // namespace
}  // namespace gnomon
