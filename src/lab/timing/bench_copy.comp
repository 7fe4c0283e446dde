// What a map conversion must move at the least: reads 4 bytes and writes 8 for each texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/frame_data.glsl"

layout(buffer_reference, scalar) writeonly buffer Pairs { vec2 v[]; };
layout(push_constant, scalar) uniform Push {
  Floats from;
  Pairs to;
  uint side;
};
layout(local_size_x = 64, local_size_y = 4) in;

void main() {
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(texel, uvec2(side)))) return;
  uint i = texel.y * side + texel.x;
  float depth = from.v[i];
  to.v[i] = vec2(depth, depth * depth);
}
