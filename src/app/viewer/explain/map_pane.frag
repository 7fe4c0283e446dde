// A layer of a shadow map, texel by texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "app/viewer/explain/map_pane_data.glsl"
#include "frame/glsl/bindless.glsl"
#include "shadow/map/glsl/map_texel.glsl"

layout(push_constant, scalar) uniform Push { MapPaneArguments arguments; };
layout(location = 0) out vec4 colour;

vec3 colour_of_object(uint id) {
  if (id == 0u) return vec3(0.0);
  uint hash = id * 0x9e3779b9u;
  return vec3(hash >> 8u & 255u, hash >> 16u & 255u, hash >> 24u) / 255.0 * 0.8 + 0.2;
}

void main() {
  ivec2 texel = ivec2(floor((gl_FragCoord.xy - arguments.origin_px) / arguments.pixels_per_texel));
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(arguments.size)))) {
    colour = vec4(0.12, 0.12, 0.14, 1.0);
    return;
  }
  vec4 value = map_texel(arguments.image, arguments.kind, arguments.layer, texel);
  if (arguments.kind == k_map_objects) {
    colour = vec4(colour_of_object(uint(value.x)), 1.0);
    return;
  }
  vec3 shown = arguments.channels == k_channels_rgb ? value.rgb : vec3(value[arguments.channels]);
  colour = vec4(clamp((shown - arguments.least) / max(arguments.most - arguments.least, 1e-30), 0.0, 1.0), 1.0);
}
