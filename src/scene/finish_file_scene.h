// The last step of the loaders: what the user may say of any file, whatever its format.
#pragma once

#include "scene/load.h"

namespace gnomon {

// Which axis is up, what blended materials cast; then checks the scene. Throws Error as check_scene does.
void finish_file_scene(Scene& scene, const SceneFileOptions& options);

}  // namespace gnomon
