// Reading a moment map at a point.
#ifndef GNOMON_MOMENTS_GLSL
#define GNOMON_MOMENTS_GLSL
#include "shadow/map/glsl/chebyshev.glsl"
#include "shadow/map/glsl/map_data.glsl"

const float k_most_anisotropy = 16.0;

vec4 moments_tap(uint map_image, MapSample at, vec2 uv, float level) {
  return textureLod(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_linear_clamp]),
                    vec3(uv, float(at.layer)), level);
}

// Bilinear; with mips the mean over the pixel's footprint: trilinear taps along its longer side, as wide as its shorter one.
// The anisotropic sampler is there for that, but Mesa's CPU driver takes a single tap where gradients are given: it blurred the
// shorter side as far as the longer, and the error in `courtyard` was half as large again.
vec4 moments_at(uint map_image, MapSample at, bool mips) {
  if (!mips) return moments_tap(map_image, at, at.uv, 0.0);
  vec2 sides = at.size * vec2(length(at.footprint_x), length(at.footprint_y));  // texels
  float longer = max(max(sides.x, sides.y), 1.0), shorter = max(min(sides.x, sides.y), 1.0);
  vec2 along = sides.x > sides.y ? at.footprint_x : at.footprint_y;
  float taps = clamp(ceil(longer / shorter), 1.0, k_most_anisotropy), level = log2(longer / taps);
  vec4 sum = vec4(0.0);
  for (float i = 0.5; i < taps; ++i) sum += moments_tap(map_image, at, at.uv + along * (i / taps - 0.5), level);
  return sum / taps;
}

#endif
