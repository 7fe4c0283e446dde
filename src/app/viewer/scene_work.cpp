#include "app/viewer/scene_work.h"

#include <algorithm>
#include <filesystem>

#include "scene/load.h"

namespace gnomon::viewer {

SceneWork& SceneWorks::of(const std::string& scene) {
  const auto builtins = builtin_scenes();
  if (std::any_of(builtins.begin(), builtins.end(), [&](const BuiltinScene& builtin) { return builtin.name == scene; })) return works_[scene];
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::weakly_canonical(scene, failed);
  return works_[failed ? scene : path.string()];
}

}  // namespace gnomon::viewer
