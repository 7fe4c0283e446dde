// Reading a moment map at a point.
#ifndef GNOMON_MOMENTS_GLSL
#define GNOMON_MOMENTS_GLSL
#include "shadow/map/glsl/chebyshev.glsl"
#include "shadow/map/glsl/map_data.glsl"

// Trilinear and anisotropic over the pixel's footprint where the filter asks for footprints, else bilinear.
vec4 moments_at(uint map_image, MapSample at) {
#ifdef GNOMON_FILTER_FOOTPRINT
  return textureGrad(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_anisotropic_clamp]), vec3(at.uv, float(at.layer)),
                     at.footprint_x, at.footprint_y);
#else
  return textureLod(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_linear_clamp]), vec3(at.uv, float(at.layer)), 0.0);
#endif
}

#endif
