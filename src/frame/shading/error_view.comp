// Signed error over the picture: vermilion where the mask is darker than the reference, blue where it is brighter
// (measure/visibility_error.h, signed_error_map, is the same on the CPU).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/surface.glsl"

layout(constant_id = 0) const uint k_samples = 1;
layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  Floats mask;       // of one light
  Floats reference;  // the same; below 0: no receiver
  Uints display;
};
layout(local_size_x = 8, local_size_y = 8) in;

const vec3 k_false_shadow = vec3(0.95, 0.33, 0.05);
const vec3 k_false_light = vec3(0.15, 0.55, 0.98);

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  uvec2 size = frame.v.camera.size;
  if (any(greaterThanEqual(pixel, size))) return;
  uint index = pixel.y * size.x + pixel.x;
  float too_dark = 0.0, too_bright = 0.0;
  for (uint s = 0u; s < k_samples; ++s) {
    float truth = reference.v[index * k_samples + s];
    if (truth < 0.0) continue;
    float difference = mask.v[index * k_samples + s] - truth;
    too_dark += max(-difference, 0.0);
    too_bright += max(difference, 0.0);
  }
  float total = (too_dark + too_bright) / float(k_samples);
  float strength = total > 1.0001 / 255.0 ? min(1.0, 0.15 + 0.85 * sqrt(total)) : 0.0;
  float grey = 0.06 + 0.5 * dot(unpackUnorm4x8(display.v[index]).rgb, vec3(0.2126, 0.7152, 0.0722));
  vec3 hue = mix(k_false_light, k_false_shadow, too_dark / max(too_dark + too_bright, 1e-20));
  display.v[index] = packUnorm4x8(vec4(mix(vec3(grey), hue, strength), 1.0));
}
