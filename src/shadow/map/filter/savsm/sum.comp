// Running sums along rows (of the encoded depth map), then along columns (of those). A thread adds up its part of a line, the
// group scans the parts in shared memory, and the thread writes its part again with what came before.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "shadow/map/filter/savsm/savsm_fixed.glsl"
#include "shadow/map/glsl/map_data.glsl"

layout(push_constant, scalar) uniform Push {
  ShadowViews views;
  uint depth_image, table, size;
  float width;
};
layout(constant_id = 0) const bool k_columns = false;
// Side by side in a group: neighbouring columns share cache lines, one row is its own neighbour.
layout(constant_id = 1) const uint k_lines = 1u;
layout(local_size_x = 256) in;

const uint k_parts = 256u / k_lines;
shared uvec2 before[256];

uvec2 value_at(ivec3 texel, int bits) {
  if (k_columns) return imageLoad(storage_images_uint[table], texel).xy;
  ShadowView view = views.v[texel.z];
  float depth = texelFetch(images_2d_array[depth_image], texel, 0).x;
  return savsm_fixed(linear_depth(view.linear_numerator, view.linear_denominator, (vec2(texel.xy) + 0.5) / float(size), depth),
                     bits);
}

void main() {
  uint layer = gl_WorkGroupID.y;
  if (views.v[layer].raster.in_use == 0u) return;
  int bits = savsm_bits(width);
  uint lane = gl_LocalInvocationIndex;
  uint part = lane / k_lines;
  uint line = gl_WorkGroupID.x * k_lines + lane % k_lines;
  uint length_of_part = (size + k_parts - 1u) / k_parts;
  uint first = min(part * length_of_part, size), last = line < size ? min(first + length_of_part, size) : first;
  uvec2 sum = uvec2(0u);
  for (uint i = first; i < last; ++i) sum += value_at(ivec3(k_columns ? ivec2(line, i) : ivec2(i, line), layer), bits);
  before[lane] = sum;
  barrier();
  // Hillis and Steele 1986, over the parts of each line.
  for (uint step = 1u; step < k_parts; step *= 2u) {
    uvec2 earlier = part >= step ? before[lane - step * k_lines] : uvec2(0u);
    barrier();
    before[lane] += earlier;
    barrier();
  }
  sum = before[lane] - sum;
  for (uint i = first; i < last; ++i) {
    ivec3 texel = ivec3(k_columns ? ivec2(line, i) : ivec2(i, line), layer);
    sum += value_at(texel, bits);
    imageStore(storage_images_uint[table], texel, uvec4(sum, 0u, 0u));
  }
}
