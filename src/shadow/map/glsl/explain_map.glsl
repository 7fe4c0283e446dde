// What a map technique does with a point, asked of the same functions that its resolve calls.
#ifndef GNOMON_EXPLAIN_MAP_GLSL
#define GNOMON_EXPLAIN_MAP_GLSL
#include "shadow/map/glsl/explain_data.glsl"
#include "shadow/map/glsl/map_sample.glsl"
#include "shadow/map/glsl/pixel_footprint.glsl"

layout(buffer_reference, scalar) readonly buffer ProjectionParamsRef { ProjectionParams v; };
layout(buffer_reference, scalar) readonly buffer BiasParamsRef { BiasParams v; };

Receiver receiver_of(CameraData camera, LightShape shape, uvec2 pixel, uint s, Surface surface) {
  Receiver receiver;
  receiver.position_ws = surface.position_ws;
  receiver.normal_ws = surface.geometric_normal_ws;
  receiver.to_light = direction_to_light(shape, surface.position_ws);
  receiver.pixel_x_ws = to_neighbour(camera, ivec2(pixel) + ivec2(1, 0), s, surface);
  receiver.pixel_y_ws = to_neighbour(camera, ivec2(pixel) + ivec2(0, 1), s, surface);
  receiver.noise = vec2(0.0);
  receiver.object = receiver.item = receiver.object_image = 0u;
  return receiver;
}

// Which texel of the map a neighbouring pixel falls on, less this pixel's: along the picture's x and y.
mat2 texels_of_pixel(MapSample at) { return mat2(at.footprint_x * at.size, at.footprint_y * at.size); }

// Side of a texel in pixels; 0 where the pixel's reach is not known.
float pixels_per_texel(MapSample at) {
  float area = abs(determinant(texels_of_pixel(at)));
  return area > 0.0 ? inversesqrt(area) : 0.0;
}

// Borders of texels, a pixel wide; where texels are smaller than some pixels, of every eighth texel, and so on: no moire.
float texel_lines(MapSample at) {
  vec2 place = at.uv * at.size;
  mat2 reach = texels_of_pixel(at);
  vec2 texels_a_pixel = abs(reach[0]) + abs(reach[1]);
  if (any(lessThanEqual(texels_a_pixel, vec2(0.0)))) return 0.0;
  float lines = 0.0;
  for (float step_texels = 1.0; step_texels <= 512.0; step_texels *= 8.0) {
    vec2 pixels = step_texels / texels_a_pixel;  // between two lines
    vec2 from_line = (0.5 - abs(fract(place / step_texels) - 0.5)) * pixels;
    vec2 line = (1.0 - smoothstep(0.5, 1.5, from_line)) * smoothstep(4.0, 10.0, pixels);
    lines = max(lines, max(line.x, line.y) * (step_texels == 1.0 ? 0.75 : 1.0));
  }
  return lines;
}

vec4 overlay_of_layer(MapSample at, uint overlay) {
  if (overlay == k_overlay_layers) return vec4(layer_colour(at.layer), 1.0);
  if (overlay == k_overlay_texels) return vec4(0.5 + 0.5 * layer_colour(at.layer), texel_lines(at));
  float pixels = pixels_per_texel(at);
  return pixels > 0.0 ? vec4(ramp_colour(footprint_place(log2(pixels))), 1.0) : vec4(0.0);
}

float depth_of_texel(ExplainArguments arguments, ivec2 texel, uint layer, float size) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(int(size))))) return k_pick_outside;
  if ((arguments.flags & k_explain_multisampled) != 0u) {
    return texelFetch(images_2d_ms_array[arguments.depth_image], ivec3(texel, layer), 0).x;
  }
  return texelFetch(images_2d_array[arguments.depth_image], ivec3(texel, layer), 0).x;
}

PickedLayer pick_layer(ExplainArguments arguments, ShadowViews views, uint layer, float weight, BiasParams bias, float radius,
                       Receiver receiver) {
  MapSample at = sample_of(views, layer, bias, radius, receiver);
  BiasParams none = bias;
  none.constant = none.slope = none.normal_offset = 0.0;
  none.receiver_plane = 1u;
  MapSample own = sample_of(views, layer, none, radius, receiver);
  PickedLayer result;
  result.layer = layer;
  result.weight = weight;
  result.uv = at.uv;
  result.depth = at.depth;
  result.linear = at.linear;
  result.unbiased_depth = own.depth;
  result.unbiased_linear = own.linear;
  result.follows_plane = bias.receiver_plane;
  result.depth_gradient = at.depth_gradient;
  result.plane_gradient = own.depth_gradient;
  result.plane_linear_gradient = own.linear_gradient;
  result.plane_move = at.plane_move;
  result.bias_linear = own.linear + dot(own.linear_gradient, at.uv - own.uv) - at.linear;
  result.texel_m = at.texel_m;
  result.size = at.size;
  result.depth_range_m = at.depth_range_m;
  result.depth_near_m = at.depth_near_m;
  result.pixels_per_texel = pixels_per_texel(at);
  result.linear_numerator = at.linear_numerator;
  result.linear_denominator = at.linear_denominator;
  ivec2 texel = clamp(ivec2(floor(at.uv * at.size)), ivec2(0), ivec2(int(at.size) - 1));
  result.texel_x = texel.x;
  result.texel_y = texel.y;
  if ((arguments.flags & k_explain_integers) != 0u) {
    result.stored = vec4(texelFetch(images_2d_array_uint[arguments.filtered_image], ivec3(texel, layer), 0));
  } else if (arguments.filtered_image == arguments.depth_image) {
    result.stored = vec4(depth_of_texel(arguments, texel, layer, at.size), 0.0, 0.0, 0.0);
  } else {
    result.stored = texelFetch(images_2d_array[arguments.filtered_image], ivec3(texel, layer), 0);
  }
  result.object = 0u;
  if ((arguments.flags & k_explain_objects) != 0u) {
    result.object = texelFetch(images_2d_array_uint[arguments.object_image], ivec3(texel, layer), 0).x;
  }
  const int middle = int(k_pick_side) / 2;
  for (uint i = 0u; i < k_pick_texels; ++i) {
    result.depths[i] = depth_of_texel(arguments, texel + ivec2(i % k_pick_side, i / k_pick_side) - middle, layer, at.size);
  }
  return result;
}

#endif
