// Biases that every projection and filter shares.
#ifndef GNOMON_BIAS_GLSL
#define GNOMON_BIAS_GLSL
#include "shadow/map/glsl/map_data.glsl"

#include "base/glsl/params_struct.glsl"
struct BiasParams {
#include "shadow/map/bias.params"
  uint table_end;
};
#include "base/params_undefine.h"

// Where the receiver is compared: moved toward the light by the constant and the slope-scaled bias, and along its normal by the
// normal offset (Holbert 2011; it grows with the sine of the angle, because a receiver that faces the light needs none).
vec3 biased_position(BiasParams bias, vec3 position_ws, vec3 normal_ws, vec3 to_light, float texel_m, float filter_radius,
                     uint layer) {
  float cosine = clamp(dot(normal_ws, to_light), 1e-4, 1.0);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float slope = min(sine / cosine, bias.max_slope);
  float unit_m = bias.unit == 0u ? texel_m : 0.01;
  unit_m *= 1.0 + bias.filter_growth * filter_radius;
  if (bias.layer_growth != 1.0) unit_m *= pow(bias.layer_growth, float(layer));
  return position_ws + normal_ws * (bias.normal_offset * unit_m * sine) +
         to_light * ((bias.constant + bias.slope * slope) * unit_m);
}

// Receiver plane (Isidoro 2006, in closed form): d depth / d uv of the plane through a point. Planes go through a projective
// map as planes: (A, B, C, D) in clip space, so depth = -(A x + B y + D) / C exactly, for perspective and warped views too.
vec2 plane_depth_gradient(mat4 world_from_clip, vec3 position_ws, vec3 normal_ws) {
  vec4 plane = vec4(normal_ws, -dot(normal_ws, position_ws)) * world_from_clip;
  if (abs(plane.z) < 1e-8 * max(abs(plane.x), abs(plane.y))) return vec2(0.0);
  // uv = ndc * 0.5 + 0.5: one unit of uv is two of ndc.
  return -2.0 * plane.xy / plane.z;
}

#endif
