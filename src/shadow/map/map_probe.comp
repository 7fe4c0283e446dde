// The value at one texel of a layer, and the range of all of them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/frame_data.glsl"
#include "shadow/map/glsl/map_texel.glsl"

layout(buffer_reference, scalar) buffer MapProbeRef { MapProbe v; };
layout(constant_id = 0) const uint k_begins = 0;  // 1: one thread that reads the texel and empties the range
layout(push_constant, scalar) uniform Push { MapProbeArguments arguments; };
layout(local_size_x = 8, local_size_y = 8) in;

const uint k_block = 4u;  // texels along a side that a thread reads
shared uint least[4], most[4];

vec4 texel_at(uvec2 texel) { return map_texel(arguments.image, arguments.kind, arguments.layer, ivec2(texel)); }

void main() {
  MapProbeRef result = MapProbeRef(arguments.result);
  if (k_begins != 0u) {
    if (gl_GlobalInvocationID.xy != uvec2(0u)) return;
    result.v.value = texel_at(uvec2(arguments.texel_x, arguments.texel_y));
    result.v.least = uvec4(0xffffffffu);
    result.v.most = uvec4(0u);
    return;
  }
  if (gl_LocalInvocationIndex < 4u) {
    least[gl_LocalInvocationIndex] = 0xffffffffu;
    most[gl_LocalInvocationIndex] = 0u;
  }
  barrier();
  uvec4 low = uvec4(0xffffffffu), high = uvec4(0u);
  for (uint i = 0u; i < k_block * k_block; ++i) {
    uvec2 texel = gl_GlobalInvocationID.xy * k_block + uvec2(i % k_block, i / k_block);
    if (any(greaterThanEqual(texel, uvec2(arguments.size)))) continue;
    vec4 value = texel_at(texel);
    if (value.x >= 1.0 && arguments.kind <= k_map_depth_samples) continue;
    uvec4 ordered =
        uvec4(order_preserving(value.x), order_preserving(value.y), order_preserving(value.z), order_preserving(value.w));
    low = min(low, ordered);
    high = max(high, ordered);
  }
  for (uint i = 0u; i < 4u; ++i) {
    atomicMin(least[i], low[i]);
    atomicMax(most[i], high[i]);
  }
  barrier();
  if (gl_LocalInvocationIndex < 4u) {
    atomicMin(result.v.least[gl_LocalInvocationIndex], least[gl_LocalInvocationIndex]);
    atomicMax(result.v.most[gl_LocalInvocationIndex], most[gl_LocalInvocationIndex]);
  }
}
