// Files: whole or not at all, and errors that name the path.
#include "base/file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_folder.h"

namespace gnomon {
namespace {

class File : public testing::Test {
 protected:
  std::filesystem::path path(const char* name) const { return folder_ / name; }

  // The message must name the path.
  template <class Action>
  static void expect_error_about(const std::filesystem::path& named, Action action) {
    try {
      action();
      ADD_FAILURE() << "no error about " << named;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(named.string()), std::string::npos) << error.what();
      EXPECT_EQ(error.code(), ExitCode::failure);
    }
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(File, WritesAndReadsBack) {
  const std::string text("line\n\0binary\xff", 13);
  write_file(path("a"), text);
  EXPECT_EQ(read_text_file(path("a")), text);
  EXPECT_EQ(read_file(path("a")).size(), 13u);
  write_file(path("a"), "");
  EXPECT_EQ(read_text_file(path("a")), "");
}

TEST_F(File, ReadsWhatDoesNotFitOneChunk) {
  const std::string text(200001, 'x');
  write_file(path("large"), text);
  EXPECT_EQ(read_text_file(path("large")), text);
}

TEST_F(File, LeavesNoPartBehind) {
  write_file(path("a"), "1");
  make_folder(path("taken"));
  write_file(path("taken/inside"), "2");
  expect_error_about(path("taken"), [&] { write_file(path("taken"), "text"); });
  size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++entries;
  EXPECT_EQ(entries, 2u);
}

TEST_F(File, ALargeFileThatWasNotFetchedIsNamedAsSuch) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0123\nsize 123456\n";
  write_file(path("model.glb"), pointer);
  for (const bool as_text : {false, true}) {
    try {
      as_text ? (void)read_text_file(path("model.glb")) : (void)read_file(path("model.glb"));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()),
                path("model.glb").string() +
                    ": is a Git LFS pointer, not the file itself; 'git lfs pull' in its folder fetches the file");
    }
  }
  write_file(path("note"), "see version https://git-lfs.github.com/spec/v1");
  EXPECT_NO_THROW(read_file(path("note")));
}

TEST_F(File, ErrorsNameThePath) {
  expect_error_about(path("missing"), [&] { read_file(path("missing")); });
  expect_error_about(folder_, [&] { read_file(folder_); });
  expect_error_about(path("missing/a"), [&] { write_file(path("missing/a"), "text"); });
  write_file(path("file"), "1");
  expect_error_about(path("file"), [&] { make_folder(path("file")); });
  EXPECT_NO_THROW(make_folder(path("new/deep")));
  EXPECT_NO_THROW(make_folder(path("new/deep")));
}

TEST(ContentHash, TellsContentApart) {
  const auto hash_of = [](std::vector<uint8_t> bytes) {
    ContentHash hash;
    hash.add_values(bytes);
    return hash.hex();
  };
  EXPECT_EQ(hash_of({}), "cbf29ce484222325");     // FNV-1a's offset basis
  EXPECT_EQ(hash_of({'a'}), "af63dc4c8601ec8c");  // and its published value of "a"
  EXPECT_EQ(hash_of({1, 2, 3}), hash_of({1, 2, 3}));
  EXPECT_NE(hash_of({1, 2, 3}), hash_of({3, 2, 1}));
  EXPECT_NE(hash_of(std::vector<uint8_t>(8)), hash_of(std::vector<uint8_t>(16)));
  EXPECT_NE(hash_of(std::vector<uint8_t>(16)), hash_of(std::vector<uint8_t>(17)));
}

}  // namespace
}  // namespace gnomon
