// Blended materials (glTF BLEND, OBJ `d` below 1): light passes through them, and a shadow map knows only yes or no.
#pragma once

#include "scene/load.h"

namespace gnomon {

// Settles what of them casts (scene.blend_casts) and says it once, for all of them. Their alpha is that of the base colour
// and, where the loader made them masked, of the texture. The camera sees them as solid whatever their alpha, but for the
// texels of their texture that are clear (k_clear_alpha): leaves that were exported as blended keep their outline.
void settle_blended(Scene& scene, const SceneFileOptions& options);

// Of 255: what an encoder may have made of 0.
inline constexpr uint8_t k_clear_alpha = 1;

}  // namespace gnomon
