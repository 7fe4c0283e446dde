// The samplers that every shader can name, for C++ and shaders: indices into the bindless set.
#ifndef GNOMON_SAMPLERS_GLSL
#define GNOMON_SAMPLERS_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

shared_constant uint k_sampler_nearest_clamp = 0u;
shared_constant uint k_sampler_linear_clamp = 1u;
shared_constant uint k_sampler_compare_linear = 2u;
shared_constant uint k_sampler_compare_nearest = 3u;
// Of material textures: nine for each of k_material_*, by wrap modes (0 repeat, 1 clamp, 2 mirror).
shared_constant uint k_sampler_material_first = 4u;

shared_constant uint k_material_anisotropic = 0u;
shared_constant uint k_material_trilinear = 1u;
shared_constant uint k_material_nearest = 2u;  // for gathers, which a CPU driver does slowly through the others

inline_function uint material_sampler(uint filtering, uint wrap_u, uint wrap_v) {
  return k_sampler_material_first + 9u * filtering + 3u * wrap_u + wrap_v;
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
