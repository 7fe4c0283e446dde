// Standard sample positions (Vulkan specification, "Multisampling"): where depth was sampled inside a pixel, in [0, 1).
#ifndef GNOMON_SAMPLE_POSITIONS_GLSL
#define GNOMON_SAMPLE_POSITIONS_GLSL

const vec2 k_positions_2[2] = vec2[](vec2(0.75, 0.75), vec2(0.25, 0.25));
const vec2 k_positions_4[4] = vec2[](vec2(0.375, 0.125), vec2(0.875, 0.375), vec2(0.125, 0.625), vec2(0.625, 0.875));
const vec2 k_positions_8[8] =
    vec2[](vec2(0.5625, 0.3125), vec2(0.4375, 0.6875), vec2(0.8125, 0.5625), vec2(0.3125, 0.1875), vec2(0.1875, 0.8125),
           vec2(0.0625, 0.4375), vec2(0.6875, 0.9375), vec2(0.9375, 0.0625));

vec2 sample_position(uint sample_index, uint samples) {
  if (samples == 2u) return k_positions_2[sample_index];
  if (samples == 4u) return k_positions_4[sample_index];
  if (samples == 8u) return k_positions_8[sample_index];
  return vec2(0.5);
}

#endif
