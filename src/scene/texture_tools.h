// Pictures made from pictures, as materials of files need them.
#pragma once

#include "base/image.h"

namespace gnomon {

bool has_transparency(const Image8& image);  // any alpha below 255
uint8_t least_alpha(const Image8& image);    // 255 of an empty picture
uint8_t greatest_alpha(const Image8& image);
// How the texels are spread over an alpha channel.
struct AlphaShares {
  double clear = 0.0;  // below 1/8
  double solid = 0.0;  // above 7/8
  double between = 0.0;
  double edges = 0.0;  // of those between: both a clear and a solid texel lie within two texels
  double holes = 0.0;  // below 1/2, where alpha tests cut
};
AlphaShares alpha_shares(const Image8& image);
// Whether such a channel looks like a cut-out: bimodal, most texels either clear or solid, as of a leaf on its sheet; and what
// lies between is the edge of that. A smooth channel (gloss, height, a tint) is none, nor one without a clear or a solid texel.
bool is_cut_out(const AlphaShares& shares);

bool is_grey(const Image8& image);  // red = green = blue everywhere

// The alpha of `colour` becomes the mask, resampled to its size: the mask's own alpha where it has one, else its brightness.
// `inverted`: the mask tells transparency.
void set_alpha(Image8& colour, const Image8& mask, bool inverted = false);

// Tangent-space normal map (+Y up) of a tiling height map. `slope`: rise over run where the height goes from 0 to 1 within a
// texel.
Image8 normal_map_from_heights(const ImageF& heights, float slope);

}  // namespace gnomon
