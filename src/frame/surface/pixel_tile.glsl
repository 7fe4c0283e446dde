// Which pixels a thread handles in kernels over the picture: four, because what all pixels share costs more to read than a
// pixel's own. A group of 8 x 8 threads covers a tile of k_pixel_tile x k_pixel_tile.
#ifndef GNOMON_PIXEL_TILE_GLSL
#define GNOMON_PIXEL_TILE_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

shared_constant uint k_pixel_tile = 16u;

#ifdef __cplusplus
}  // namespace gnomon
#else
uvec2 pixel_of_tile(uint i) { return gl_WorkGroupID.xy * k_pixel_tile + gl_LocalInvocationID.xy + 8u * uvec2(i & 1u, i >> 1u); }
#endif

#endif
