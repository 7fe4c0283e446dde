// Whether an alpha-tested caster exists at a uv, for rays: texel fetches around base/glsl/alpha.glsl.
#ifndef GNOMON_ALPHA_TEST_GLSL
#define GNOMON_ALPHA_TEST_GLSL
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/frame_data.glsl"
#include "base/glsl/alpha.glsl"

bool alpha_exists(MaterialData material, vec2 uv) {
  if (material.caster_cutoff < 0.0) return true;
  float alpha = material.base_colour.a;
  if (material.caster_texture != k_no_texture_index) {
    uint image = material.caster_texture;
    ivec2 size = textureSize(material_textures[nonuniformEXT(image)], 0);
    vec2 position = texel_position(transform_uv(material.base_uv_u, material.base_uv_v, uv), size);
    ivec2 low = texel_below(position);
    int x0 = wrap_texel(low.x, size.x, material.base_wrap_u), x1 = wrap_texel(low.x + 1, size.x, material.base_wrap_u);
    int y0 = wrap_texel(low.y, size.y, material.base_wrap_v), y1 = wrap_texel(low.y + 1, size.y, material.base_wrap_v);
    alpha *= bilinear_alpha(texelFetch(material_textures[nonuniformEXT(image)], ivec2(x0, y0), 0).a,
                            texelFetch(material_textures[nonuniformEXT(image)], ivec2(x1, y0), 0).a,
                            texelFetch(material_textures[nonuniformEXT(image)], ivec2(x0, y1), 0).a,
                            texelFetch(material_textures[nonuniformEXT(image)], ivec2(x1, y1), 0).a, texel_weight(position));
  }
  return alpha >= material.caster_cutoff;
}

#endif
