// Where the sources are, and the scenes beside them that tests read where they are present.
#pragma once

#include <filesystem>

namespace gnomon {

std::filesystem::path source_dir();
std::filesystem::path shared_scenes();  // may be missing

}  // namespace gnomon
