// The list of files opened last.
#include "app/viewer/state/recent_files.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"

namespace gnomon::viewer {
namespace {

class RecentFilesTest : public testing::Test {
 protected:
  std::string make(const std::string& name) {
    write_file(folder_ / name, std::string_view("x"));
    return (folder_ / name).string();
  }
  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
  std::filesystem::path list_ = folder_ / "state" / "recent";
};

TEST_F(RecentFilesTest, TheNewestFirstAndEachOnce) {
  const std::string a = make("a.obj"), b = make("b with blank.obj");
  RecentFiles recent(list_);
  EXPECT_TRUE(recent.paths().empty());
  recent.add(a);
  recent.add(b);
  recent.add(folder_ / "." / "a.obj");
  EXPECT_EQ(recent.paths(), (std::vector<std::string>{a, b}));
  EXPECT_EQ(RecentFiles(list_).paths(), recent.paths()) << "kept between runs";
}

TEST_F(RecentFilesTest, ForgetsWhatIsGoneAndWhatIsOld) {
  RecentFiles recent(list_);
  std::string last;
  for (size_t i = 0; i < RecentFiles::k_most + 3; ++i) recent.add(last = make(std::to_string(i) + ".obj"));
  EXPECT_EQ(recent.paths().size(), RecentFiles::k_most);
  std::filesystem::remove(last);
  EXPECT_EQ(RecentFiles(list_).paths().size(), RecentFiles::k_most - 1);
}

TEST_F(RecentFilesTest, AListThatCannotBeWrittenIsNoError) {
  make("file");
  RecentFiles recent(folder_ / "file" / "recent");
  recent.add(make("a.obj"));
  EXPECT_EQ(recent.paths().size(), 1u);
}

}  // namespace
}  // namespace gnomon::viewer
