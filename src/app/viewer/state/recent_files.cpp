#include "app/viewer/state/recent_files.h"

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "base/user_folder.h"

namespace gnomon::viewer {

std::filesystem::path RecentFiles::default_list() {
  const auto folder = user_folder(UserFolder::state);
  return folder.empty() ? folder : folder / "recent";
}

RecentFiles::RecentFiles(std::filesystem::path list) : list_(std::move(list)) {
  std::ifstream file(list_);
  for (std::string line; std::getline(file, line) && paths_.size() < k_most;) {
    std::error_code ignored;
    if (!line.empty() && std::filesystem::exists(line, ignored)) paths_.push_back(line);
  }
}

void RecentFiles::add(const std::filesystem::path& path) {
  std::error_code failed;
  const std::string absolute = std::filesystem::absolute(path, failed).lexically_normal().string();
  if (failed) return;
  std::erase(paths_, absolute);
  paths_.insert(paths_.begin(), absolute);
  paths_.resize(std::min(paths_.size(), k_most));
  if (list_.empty()) return;
  std::string text;
  for (const std::string& line : paths_) text += line + "\n";
  try {
    make_folder(list_.parent_path());
    write_file(list_, text);
  } catch (const Error& error) {
    log_warning("the list of recent files is not kept: {}", error.what());
  }
}

}  // namespace gnomon::viewer
