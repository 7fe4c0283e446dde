// A depth map blended with the last frame's. Depths go to a buffer, from which they are copied into the map: compute cannot
// write a depth format, and the next frame reads them there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "frame/surface/pixel_tile.glsl"
#include "shadow/map/glsl/bilinear.glsl"
#include "shadow/map/glsl/history.glsl"

layout(buffer_reference, scalar) buffer Depths { float v[]; };
layout(push_constant, scalar) uniform Push {
  ShadowViews views, last_views;
  Depths last, blended;
  uint depth_image, size;
  float history;  // 0: there is no last map
};
layout(local_size_x = 8, local_size_y = 8) in;

uint index_of(ivec3 texel) { return (uint(texel.z) * size + uint(texel.y)) * size + uint(texel.x); }

// The last map's depth for the surface that this one has at (uv, depth), in this map's units. False where it saw none.
bool last_depth(ShadowView now, ShadowView before, ivec3 texel, float depth, out float found) {
  vec3 there, here;
  if (!seen_from(now, before, vec3((vec2(texel.xy) + 0.5) / float(size), depth), there)) return false;
  ivec2 texels[4];
  float weights[4];
  bilinear_taps(there.xy, float(size), texels, weights);
  there.z = 0.0;
  for (int i = 0; i < 4; ++i) there.z += weights[i] * last.v[index_of(ivec3(texels[i], texel.z))];
  bool seen = seen_from(before, now, there, here);
  // What stood nowhere still does: the far plane may have moved.
  found = there.z >= 1.0 ? 1.0 : clamp(here.z, 0.0, 1.0);
  return seen || there.z >= 1.0;
}

void main() {
  uint layer = gl_WorkGroupID.z;
  ShadowView now = views.v[layer];
  ShadowView before = now;
  uint kind = k_history_none;
  if (history > 0.0) {
    before = last_views.v[layer];
    kind = history_of(now, before);
  }
  for (uint i = 0u; i < 4u; ++i) {
    ivec3 texel = ivec3(pixel_of_tile(i), layer);
    if (any(greaterThanEqual(texel.xy, ivec2(size)))) continue;
    float depth = texelFetch(images_2d_array[depth_image], texel, 0).x, found;
    uint index = index_of(texel);
    if (kind == k_history_same) {
      depth = mix(depth, last.v[index], history);
    } else if (kind == k_history_moved && last_depth(now, before, texel, depth, found)) {
      depth = mix(depth, found, history);
    }
    blended.v[index] = depth;
  }
}
