// glTF: not read yet.
#include "base/error.h"
#include "scene/load.h"

namespace gnomon {
Scene load_gltf(const std::filesystem::path& path) { fail("{}: glTF is not read yet", path.string()); }
Scene load_gltf_from_memory(std::span<const std::byte>, const std::string& name, const std::filesystem::path&) {
  fail("{}: glTF is not read yet", name);
}
}  // namespace gnomon
