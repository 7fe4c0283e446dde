#include "app/viewer/state/scene_work.h"

#include <algorithm>
#include <filesystem>

#include "scene/load.h"

namespace gnomon::viewer {

namespace {

// The same for all names of one scene.
std::string identity_of(const std::string& scene) {
  const auto builtins = builtin_scenes();
  if (std::any_of(builtins.begin(), builtins.end(), [&](const BuiltinScene& builtin) { return builtin.name == scene; }))
    return scene;
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::weakly_canonical(scene, failed);
  return failed ? scene : path.string();
}

}  // namespace

bool same_scene(const std::string& a, const std::string& b) { return identity_of(a) == identity_of(b); }

SceneWork& SceneWorks::of(const std::string& scene) { return works_[identity_of(scene)]; }

}  // namespace gnomon::viewer
