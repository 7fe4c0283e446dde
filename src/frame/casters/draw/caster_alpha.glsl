// Alpha tests of casters in the raster: the same four texels of mip 0 and the same arithmetic (base/glsl/alpha.glsl) as a
// ray's, so that a texel of the map is the point sample of the caster that a ray through it would be. The vertex shader looks
// the material up, which a fragment would do again and again, and one gather fetches the texels.
#ifndef GNOMON_CASTER_ALPHA_GLSL
#define GNOMON_CASTER_ALPHA_GLSL
#include "base/glsl/alpha.glsl"
#include "frame/glsl/texture_lookup.glsl"

// What a fragment knows of its material.
struct AlphaLookup {
  vec4 scale;    // of a texel in uv; alpha of the material without its texture; least alpha that exists
  uint texture;  // texture_lookup()
};

AlphaLookup alpha_lookup(MaterialData material, vec2 uv, out vec2 position) {
  AlphaLookup lookup = AlphaLookup(vec4(1.0, 1.0, material.base_colour.a, material.caster_cutoff), k_no_texture_index);
  position = vec2(0.0);
  if (material.caster_cutoff >= 0.0 && material.caster_texture != k_no_texture_index) {
    ivec2 size = textureSize(material_textures[nonuniformEXT(material.caster_texture)], 0);
    position = texel_position(transform_uv(material.base_uv_u, material.base_uv_v, uv), size);
    lookup.scale.xy = 1.0 / vec2(size);
    uint nearest = material_sampler(k_material_nearest, material.base_wrap_u, material.base_wrap_v);
    lookup.texture = texture_lookup(material.caster_texture, nearest);
  }
  return lookup;
}

bool alpha_exists(AlphaLookup lookup, vec2 position) {
  float alpha = lookup.scale.z;
  if (lookup.texture != k_no_texture_index) {
    // At the corner that the four share, where no rounding picks others.
    vec4 four = textureGather(LOOKUP_SAMPLER2D(lookup.texture), (floor(position) + 1.0) * lookup.scale.xy, 3);
    alpha *= bilinear_alpha(four.w, four.z, four.x, four.y, texel_weight(position));
  }
  return alpha >= lookup.scale.w;
}

#endif
