// Blended materials (glTF BLEND, OBJ `d` below 1): light passes through them, and a shadow map knows only yes or no.
#pragma once

#include "scene/load.h"

namespace gnomon {

// Settles what of them casts (scene.blend_casts) and says it once, for all of them. Their alpha is that of the base colour
// and, where the loader made them masked, of the texture. The camera sees them as solid, but for what their texture leaves
// below half.
void settle_blended(Scene& scene, const SceneFileOptions& options);

}  // namespace gnomon
