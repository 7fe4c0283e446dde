// Counts what the surface pass writes: one for each fragment that exists.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/texture_lookup.glsl"

// As surface.vert writes them.
layout(location = 0) in vec4 uv;
layout(location = 4) flat in vec3 scalars;
layout(location = 5) flat in uvec4 ids;

layout(location = 0) out float written;

void main() {
  float alpha = scalars.x;
  if (ids.z != k_no_texture_index) alpha *= texture(LOOKUP_SAMPLER2D(ids.z), uv.xy).a;
  if (alpha < scalars.y) discard;
  written = 1.0;
}
