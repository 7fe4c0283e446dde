// OBJ: not read yet.
#include "base/error.h"
#include "scene/load.h"

namespace gnomon {
Scene load_obj(const std::filesystem::path& path) { fail("{}: OBJ is not read yet", path.string()); }
Scene load_obj_from_memory(std::string_view, const std::string& name, const std::filesystem::path&) {
  fail("{}: OBJ is not read yet", name);
}
}  // namespace gnomon
