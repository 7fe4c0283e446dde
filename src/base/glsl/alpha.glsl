// Where an alpha-tested surface exists: the arithmetic of the lookup, without texture access, so that any-hit shaders
// (texelFetch) and the CPU reference give the same answer. Four texels of mip 0 make the alpha at a point:
//   vec2 position = texel_position(transform_uv(row_u, row_v, interpolate_uv(uv0, uv1, uv2, u, v)), size);
//   ivec2 low = texel_below(position);       // and low + (1,0), (0,1), (1,1), each through wrap_texel
//   bool exists = base_alpha * bilinear_alpha(a00, a10, a01, a11, texel_weight(position)) >= alpha_cutoff;
#ifndef GNOMON_ALPHA_GLSL
#define GNOMON_ALPHA_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// As scene/scene.h's Wrap.
shared_constant uint k_wrap_repeat = 0u;
shared_constant uint k_wrap_clamp = 1u;
shared_constant uint k_wrap_mirror = 2u;

// `i` modulo `size`, in [0, size): GLSL leaves the remainder of negative numbers undefined.
inline_function int positive_modulo(int i, int size) { return i >= 0 ? i % size : size - 1 - (-1 - i) % size; }

inline_function int wrap_texel(int i, int size, uint mode) {
  if (mode == k_wrap_clamp) return clamp(i, 0, size - 1);
  if (mode == k_wrap_repeat) return positive_modulo(i, size);
  int mirrored = positive_modulo(i, 2 * size);
  return mirrored < size ? mirrored : 2 * size - 1 - mirrored;
}

// u and v are the barycentric weights of the second and the third vertex, as Vulkan and Embree report them.
inline_function vec2 interpolate_uv(vec2 uv0, vec2 uv1, vec2 uv2, float u, float v) {
  exact_float vec2 uv = (1.0f - u - v) * uv0 + u * uv1 + v * uv2;
  return uv;
}

// Rows of the 2x3 matrix of KHR_texture_transform (UvTransform in scene/scene.h).
inline_function vec2 transform_uv(vec3 row_u, vec3 row_v, vec2 uv) {
  exact_float vec2 result = vec2(row_u.x * uv.x + row_u.y * uv.y + row_u.z, row_v.x * uv.x + row_v.y * uv.y + row_v.z);
  return result;
}

// In texels, relative to the centre of texel (0,0). Bounded so that its integer part fits an int.
inline_function vec2 texel_position(vec2 uv, ivec2 size) {
  exact_float vec2 position = uv * vec2(size) - vec2(0.5f, 0.5f);
  return clamp(position, vec2(-1.0e9f, -1.0e9f), vec2(1.0e9f, 1.0e9f));
}
inline_function ivec2 texel_below(vec2 position) { return ivec2(floor(position)); }
inline_function vec2 texel_weight(vec2 position) { return position - floor(position); }

// a + w (b - a) rather than (1 - w) a + w b: equal texels then give exactly their value, which may be the cutoff itself.
inline_function float bilinear_alpha(float a00, float a10, float a01, float a11, vec2 weight) {
  exact_float float above = a00 + weight.x * (a10 - a00);
  exact_float float below = a01 + weight.x * (a11 - a01);
  exact_float float alpha = above + weight.y * (below - above);
  return alpha;
}

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
