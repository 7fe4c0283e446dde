// WebP pictures (libwebp).
#pragma once

#include "base/image.h"

namespace gnomon {

bool is_webp(std::span<const std::byte> encoded);

// As decode_image does; of an animation nothing but an error.
Image8 decode_webp(std::span<const std::byte> encoded, const std::string& name);

}  // namespace gnomon
