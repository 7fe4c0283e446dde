// Finds the files that a scene file names - pictures, material libraries, buffers - as exporters write the names: relative to
// one folder or another, in another case of letters, with backslashes, as paths of the author's machine.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

class FileFinder {
 public:
  // `source`: the scene file, for the message.
  explicit FileFinder(std::string source) : source_(std::move(source)) {}
  // Says in one line what only the looser rules found.
  ~FileFinder();
  FileFinder(const FileFinder&) = delete;
  FileFinder& operator=(const FileFinder&) = delete;

  // A regular file (a device such as /dev/zero would be read for ever) at `name` below the first of the folders that has it;
  // nullopt where there is none. An empty folder has nothing. Slashes may be backslashes, the name may stand in quotes.
  std::optional<std::filesystem::path> find_exactly(const std::string& name,
                                                    std::span<const std::filesystem::path> folders) const;
  // The same; where there is none, in any case of letters, and with fewer and fewer of the leading folders of `name`.
  std::optional<std::filesystem::path> find(const std::string& name, std::span<const std::filesystem::path> folders);

 private:
  void say_what_was_guessed() const;
  std::optional<std::filesystem::path> walk(const std::filesystem::path& folder, std::span<const std::string> steps);
  std::optional<std::string> entry_like(const std::filesystem::path& folder, const std::string& name);

  std::string source_;
  std::map<std::filesystem::path, std::map<std::string, std::string>> entries_;  // of folders, by their lower case
  std::map<std::string, std::filesystem::path> guessed_;                         // name in the file -> what was taken
};

}  // namespace gnomon
