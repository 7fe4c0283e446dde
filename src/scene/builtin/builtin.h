// What the file of a built-in scene needs: scenes/<id>.cpp, or scenes/<id>/<id>.cpp, defines `BuiltinScene
// builtin_scene_<id>()`, and the build finds it (src/scene/CMakeLists.txt).
#pragma once

#include <map>
#include <string>

#include "scene/load.h"
#include "scene/scene.h"

namespace gnomon {

using BuiltinOptions = std::map<std::string, double>;  // every option present and in range

}  // namespace gnomon
