// exp(c z) averaged over the kernel, times exp(-c d) (Annen et al. 2008, eq. 6).
#define GNOMON_FILTER_FOOTPRINT
#include "shadow/map/filter/esm/esm_scale.glsl"
#include "shadow/map/glsl/bilinear.glsl"
#include "shadow/map/glsl/moments.glsl"

float filter_radius(FilterParams params) { return float(params.blur) + 1.0 + 0.5 * float(params.prefilter); }

// log of the bilinear mean of the exponentials of four logarithms.
float bilinear_log(uint map_image, MapSample at) {
  ivec2 texels[4];
  float x[4], weights[4], most = -1e30;
  bilinear_taps(at.uv, at.size, texels, weights);
  for (int i = 0; i < 4; ++i) {
    x[i] = texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texels[i], at.layer), 0).x;
    // The largest that counts: beside a larger one without weight the others would vanish.
    if (weights[i] > 1e-6) most = max(most, x[i]);
  }
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += weights[i] > 1e-6 ? weights[i] * exp(x[i] - most) : 0.0;
  return most + log(sum);
}

float lit(uint map_image, MapSample at, FilterParams params) {
  // A 2x2 mean lies at the corner of its texels.
  if (params.prefilter != 0u) at.uv -= 0.5 / at.size;
  float exponent = esm_exponent(params.c, params.unit, params.space, at.depth_range_m);
  float average;
  if (params.space == space_log) {
    average = params.mips != 0u ? moments_at(map_image, at, true).x : bilinear_log(map_image, at);
  } else {
    average = log(max(moments_at(map_image, at, params.mips != 0u).x, 1e-37));
  }
  float receiver = exponent * (clamp(at.linear, 0.0, 1.0) - 0.5);
  // The difference of logarithms, and not a product of exponentials, which could be infinity times zero.
  return reduce_bleeding(exp(min(average - receiver, 0.0)), params.bleeding);
}
