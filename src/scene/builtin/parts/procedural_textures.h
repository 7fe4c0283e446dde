// Pictures for the built-in scenes' materials, square and seamless unless said otherwise. sRGB colours.
#pragma once

#include "base/image.h"
#include "base/maths.h"

namespace gnomon {

struct SurfaceTexture {
  Image8 colour, normal;  // tangent space, +Y up
};

SurfaceTexture paving_texture(int size);     // irregular setts in courses; a repeat is about two metres
SurfaceTexture masonry_texture(int size);    // blocks of warm stone in courses
SurfaceTexture plaster_texture(int size);    // ochre, stained and patched
SurfaceTexture limestone_texture(int size);  // pale, dressed, pitted
SurfaceTexture terracotta_texture(int size);
SurfaceTexture wood_texture(int size);  // grain along u
SurfaceTexture bark_texture(int size);  // ridges along v
SurfaceTexture soil_texture(int size);  // grass, earth and gravel

// A twig on a clear background, stem at the bottom centre, alpha with soft edges (alpha test at 0.5). The colour under clear
// texels is the leaves' own, so that filtering bleeds no fringe.
struct TwigStyle {
  int leaf_pairs = 7;
  float leaf_length = 0.3f, leaf_width = 0.075f;  // of the picture
  float spread = 0.9f;                            // angle between stem and leaf [radians]
  vec3 colour = vec3(0.5f), colour_variation = vec3(0.1f);
  uint32_t seed = 1;
};
Image8 twig_texture(int size, const TwigStyle& style);

// Wrought-iron panel: bars, rails, rings and spear points; repeats in u only. Opaque below, clear above the points.
Image8 iron_panel_texture(int size);

}  // namespace gnomon
