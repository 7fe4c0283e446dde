// The only file of the tests that is compiled with paths of this machine.
#include "support/paths.h"

namespace gnomon {

std::filesystem::path source_dir() { return GNOMON_SOURCE_DIR; }
std::filesystem::path shared_scenes() { return std::filesystem::path(GNOMON_SHARED_DIR) / "scenes"; }

}  // namespace gnomon
