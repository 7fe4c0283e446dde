// Materials of OBJ files: MTL text and the pictures that it names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// Adds to the scene one material for each name (in order; "" is the default one) and the textures that they use. What is
// missing - a library, a name in it, a picture - is a warning that starts with `source`, and the material keeps its colour.
// `libraries`: what follows `mtllib`; files are looked for in `folder` (empty: none is found).
void add_obj_materials(Scene& scene, const std::string& source, const std::filesystem::path& folder,
                       const std::vector<std::string>& libraries, const std::vector<std::string>& names);

}  // namespace gnomon
