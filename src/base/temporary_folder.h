// A folder of its own for each user of it, gone afterwards: nothing is shared with what runs at the same time.
#pragma once

#include <filesystem>

namespace gnomon {

class TemporaryFolder {
 public:
  // Throws Error where none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gnomon
