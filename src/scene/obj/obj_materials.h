// Materials of OBJ files: MTL text and the pictures that it names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/load.h"
#include "scene/scene.h"

namespace gnomon {

struct ObjSource {
  std::string name;              // for messages
  std::filesystem::path folder;  // where files are looked for; empty: none is found
  SceneFileOptions options;
};

struct ObjMaterialUse {
  std::string name;
  bool has_uvs = false;  // some face of it has texture coordinates
};

// Adds to the scene one material for each name (in order; "" is the default one) and the textures that they use. What is
// missing - a library, a name in it, a picture - is a warning, and the material keeps its colour. `libraries`: what follows
// `mtllib`.
void add_obj_materials(Scene& scene, const ObjSource& source, const std::vector<std::string>& libraries,
                       const std::vector<ObjMaterialUse>& uses);

}  // namespace gnomon
