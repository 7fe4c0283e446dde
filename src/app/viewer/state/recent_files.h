// The scene files opened last, kept between runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::viewer {

class RecentFiles {
 public:
  static constexpr size_t k_most = 10;

  // Reads `list`; there is none yet where it cannot be read.
  explicit RecentFiles(std::filesystem::path list = default_list());

  // The newest first; what is gone from the disk is left out.
  const std::vector<std::string>& paths() const { return paths_; }
  // Puts a file first. A list that cannot be written is no error: only the memory of it is lost.
  void add(const std::filesystem::path& path);

  // "recent" in the user's state folder (XDG_STATE_HOME, or ~/.local/state); empty where there is no home.
  static std::filesystem::path default_list();

 private:
  std::filesystem::path list_;
  std::vector<std::string> paths_;
};

}  // namespace gnomon::viewer
