// Alpha-tested casters: the texture at mip 0, bilinear, as the reference looks it up. A texel of the map is then the same point
// sample of the caster that a ray through it would be.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/draw/caster_alpha.glsl"

layout(location = 0) in vec2 texel;
layout(location = 3) flat in AlphaLookup lookup;

void main() {
  if (!alpha_exists(lookup, texel)) discard;
}
