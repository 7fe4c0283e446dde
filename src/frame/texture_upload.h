// Material textures on the GPU, with their mip chain.
#pragma once

#include "gpu/image.h"
#include "scene/scene.h"

namespace gnomon {

// RGBA8, sRGB or linear as the texture says; mips by repeated 2x2 filtering on the GPU (in linear light).
Image upload_texture(Device& device, const Texture& texture);

}  // namespace gnomon
