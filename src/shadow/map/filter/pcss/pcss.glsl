// Blocker search, penumbra by similar triangles, a disc of comparisons as wide. (Fernando 2005)
#define GNOMON_FILTER_NOISE
#include "shadow/map/glsl/compare.glsl"
#include "shadow/map/glsl/disc.glsl"

vec2 disc_point(FilterParams params, int i, int n) {
  return params.pattern == pattern_poisson ? poisson_point(i) : vogel_point(i, n);
}

// Radius at the receiver, in texels, of what a blocker at that linear depth hides of the light. Similar triangles: emitter /
// distance of the blocker = penumbra / gap; the rays to a sun of angular radius a spread by tan(a) for each metre.
float penumbra_texels(MapSample at, FilterParams params, float blocker) {
  float gap_m = max(at.linear - blocker, 0.0) * at.depth_range_m;
  float spread = params.light_scale * at.emitter_radius;
  if (!at.parallel) spread /= max(at.depth_near_m + blocker * at.depth_range_m, 1e-4);
  return spread * gap_m / max(at.texel_m, 1e-20);
}

// Mean linear depth of the texels that are nearer to the light than the receiver's plane; 2 where there are none.
float mean_blocker(uint map_image, MapSample at, FilterParams params, mat2 turn) {
  // No blocker is nearer than linear depth 0. What the least penumbra will filter is searched too.
  float reach = min(max(penumbra_texels(at, params, 0.0), params.min_radius), params.max_radius);
  float sum = 0.0, count = 0.0;
  for (int i = 0; i < params.search_taps; ++i) {
    // Denser toward the middle: low blockers, with their narrow cones, are found there alone.
    vec2 point = disc_point(params, i, params.search_taps);
    vec2 offset = turn * point * (length(point) * reach);
    vec2 texel = floor(at.uv * at.size + offset);
    vec2 uv = (texel + 0.5) / at.size;
    if (any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, vec2(at.size)))) continue;
    float stored = texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texel, at.layer), 0).x;
    if (stored >= depth_at(at, uv)) continue;
    float blocker = linear_depth(at.linear_numerator, at.linear_denominator, uv, stored);
    // Half a texel's diagonal more: the texel is not a point.
    if (params.cone != 0u && length(offset) > max(penumbra_texels(at, params, blocker), params.min_radius) + 0.71) continue;
    sum += blocker;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 2.0;
}

// The map's depth per metre toward the light at the receiver: the inverse derivative of linear_depth.
float depth_per_m(MapSample at) {
  vec4 ndc = vec4(at.uv * 2.0 - 1.0, at.depth, 1.0);
  float change = (at.linear_numerator.z - at.linear * at.linear_denominator.z) / dot(at.linear_denominator, ndc);
  return change > 0.0 ? 1.0 / (change * at.depth_range_m) : 0.0;
}

float lit(uint map_image, MapSample at, FilterParams params) {
  mat2 turn = disc_turn(params.rotate != 0u ? at.noise.x : 0.0);
  float radius = 0.0, gap_depth = 0.0;
  // A light without size has no penumbra to look for.
  if (at.emitter_radius * params.light_scale > 0.0) {
    float blocker = mean_blocker(map_image, at, params, turn);
    if (blocker > 1.5) return compare_bilinear(map_image, at, at.uv);
    radius = penumbra_texels(at, params, blocker);
    // What a tap meets hides the light only if it stands high enough above the receiver for its distance: not the next paving
    // stone.
    gap_depth = params.rise * max(at.linear - blocker, 0.0) * at.depth_range_m * depth_per_m(at);
  }
  radius = min(max(radius, params.min_radius), params.max_radius);
  if (radius == 0.0) return compare_bilinear(map_image, at, at.uv);
  float sum = 0.0;
  for (int i = 0; i < params.taps; ++i) {
    vec2 point = disc_point(params, i, params.taps);
    MapSample tap = at;
    tap.depth -= length(point) * gap_depth;
    sum += compare_bilinear(map_image, tap, at.uv + turn * point * (radius / at.size));
  }
  return sum / float(params.taps);
}

// Shadows that touch their caster have no wider kernel; biases that grow with a wide one would detach them.
float filter_radius(FilterParams params) { return params.min_radius + 1.0; }
