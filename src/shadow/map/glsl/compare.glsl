// Comparisons of the receiver's plane with stored depths: what percentage-closer filters are made of. 1 lit, 0 shadowed. Each
// texel is compared with the depth that the plane has at that texel's own centre, so no slack is needed that would detach
// shadows. (One depth for all four texels of a tap, lowered by the plane's change within a texel, lit 71 % of a forest whose
// texels are metres wide.)
#ifndef GNOMON_COMPARE_GLSL
#define GNOMON_COMPARE_GLSL
#include "shadow/map/glsl/map_data.glsl"

bool has_plane(MapSample at) { return at.depth_gradient != vec2(0.0); }

// Beyond the far plane compares as the far plane itself: what the map does not reach is lit.
float depth_at(MapSample at, vec2 uv) {
  return min(at.depth + clamp(dot(at.depth_gradient, uv - at.uv), -at.plane_move, at.plane_move), 1.0);
}

// Outside the map is lit.
float compare_texel(uint map_image, MapSample at, ivec2 texel) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(int(at.size))))) return 1.0;
  float receiver = depth_at(at, (vec2(texel) + 0.5) / at.size);
  return texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texel, at.layer), 0).x >= receiver ? 1.0 : 0.0;
}

// Of the texels `first` + (0,0), (1,0), (0,1), (1,1).
vec4 compare_four(uint map_image, MapSample at, vec2 first) {
  vec2 middle = (first + 1.0) / at.size;
  vec4 stored = textureGather(sampler2DArray(images_2d_array[nonuniformEXT(map_image)], samplers[k_sampler_nearest_clamp]),
                              vec3(middle, float(at.layer))).wzxy;
  float start = dot(at.depth_gradient, middle - 0.5 / at.size - at.uv);
  vec2 step_depth = at.depth_gradient / at.size;
  vec4 move = start + vec4(0.0, step_depth.x, step_depth.y, step_depth.x + step_depth.y);
  vec4 receiver = min(at.depth + clamp(move, -at.plane_move, at.plane_move), vec4(1.0));
  bvec4 lit = greaterThanEqual(stored, receiver);
  bvec2 low = lessThan(first, vec2(0.0)), next_low = lessThan(first, vec2(-1.0));
  bvec2 high = greaterThanEqual(first, vec2(at.size)), next_high = greaterThanEqual(first, vec2(at.size - 1.0));
  bvec2 out_first = bvec2(low.x || high.x, low.y || high.y),
        out_next = bvec2(next_low.x || next_high.x, next_low.y || next_high.y);
  return vec4(lit.x || out_first.x || out_first.y, lit.y || out_next.x || out_first.y, lit.z || out_first.x || out_next.y,
              lit.w || out_next.x || out_next.y);
}

// One depth for the four texels around uv, by the sampler: exact where the receiver faces the light, or without the plane.
float compare_sampler(uint map_image, MapSample at, vec2 uv) {
  return texture(sampler2DArrayShadow(images_2d_array[nonuniformEXT(map_image)], shadow_samplers[k_sampler_compare_linear]),
                 vec4(uv, float(at.layer), at.depth));
}

// The four texels around uv, weighted bilinearly.
float compare_bilinear(uint map_image, MapSample at, vec2 uv) {
  if (!has_plane(at)) return compare_sampler(map_image, at, uv);
  vec2 place = uv * at.size - 0.5;
  vec2 first = floor(place), part = place - first;
  vec4 lit = compare_four(map_image, at, first);
  vec2 rows = mix(lit.xz, lit.yw, part.x);
  return mix(rows.x, rows.y, part.y);
}

#endif
