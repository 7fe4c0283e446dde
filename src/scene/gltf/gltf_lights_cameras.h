// Lights and cameras of a glTF file, before nodes place them.
#pragma once

#include "scene/gltf/gltf_json.h"
#include "scene/scene.h"

namespace gnomon {

// An element of `cameras`; without a name of its own it has none. A perspective without zfar, which reaches to infinity, has
// far = 0.
Camera read_gltf_camera(const GltfValue& json);

// An element of `lights` of KHR_lights_punctual; the same of names.
Light read_gltf_light(const GltfValue& json);

}  // namespace gnomon
