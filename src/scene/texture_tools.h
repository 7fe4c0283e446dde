// Pictures made from pictures, as materials of files need them.
#pragma once

#include "base/image.h"

namespace gnomon {

bool has_transparency(const Image8& image);  // any alpha below 255
bool is_grey(const Image8& image);           // red = green = blue everywhere

// The alpha of `colour` becomes the mask, resampled to its size: the mask's own alpha where it has one, else its brightness.
void set_alpha(Image8& colour, const Image8& mask);

// Tangent-space normal map (+Y up) of a tiling height map. `slope`: rise over run where the height goes from 0 to 1 within a
// texel.
Image8 normal_map_from_heights(const ImageF& heights, float slope);

}  // namespace gnomon
