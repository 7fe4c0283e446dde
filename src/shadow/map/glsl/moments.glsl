// Reading a moment map at a point.
#ifndef GNOMON_MOMENTS_GLSL
#define GNOMON_MOMENTS_GLSL
#include "shadow/map/glsl/chebyshev.glsl"
#include "shadow/map/glsl/map_data.glsl"

// Bilinear, or through the mipmaps, trilinear and anisotropic over the pixel's footprint (the filter asks for footprints).
vec4 moments_at(uint map_image, MapSample at, bool mips) {
  vec3 place = vec3(at.uv, float(at.layer));
  return mips ? textureGrad(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_anisotropic_clamp]), place,
                            at.footprint_x, at.footprint_y)
              : textureLod(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_linear_clamp]), place, 0.0);
}

#endif
