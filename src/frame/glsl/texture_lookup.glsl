// A material texture with its sampler as one number, which vertex shaders hand to fragment shaders.
#ifndef GNOMON_TEXTURE_LOOKUP_GLSL
#define GNOMON_TEXTURE_LOOKUP_GLSL
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/frame_data.glsl"

// k_no_texture_index stays what it is.
uint texture_lookup(uint image, uint wrap) { return image == k_no_texture_index ? image : image | wrap << 24u; }

#define LOOKUP_SAMPLER2D(lookup) \
  sampler2D(material_textures[nonuniformEXT((lookup) & 0xffffffu)], samplers[nonuniformEXT((lookup) >> 24u)])

#endif
