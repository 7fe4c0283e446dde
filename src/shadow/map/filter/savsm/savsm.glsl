// The moments of any rectangle from the four corners of a summed-area table (Crow 1984; Lauritzen, GPU Gems 3, chapter 8).
#include "shadow/map/filter/savsm/savsm_fixed.glsl"
#include "shadow/map/glsl/chebyshev.glsl"

float filter_radius(FilterParams params) { return 0.5 * params.width; }

// Sum over the texels before `corner` in x and y.
uvec2 table_at(uint map_image, uint layer, ivec2 corner) {
  if (any(lessThanEqual(corner, ivec2(0)))) return uvec2(0u);
  return texelFetch(images_2d_array_uint[nonuniformEXT(map_image)], ivec3(corner - 1, layer), 0).xy;
}

// Along one axis: the four corners that bound [low, high] and the weights with which the table's sums there, linearly
// interpolated, make the sum over it. The weights add up to 0.
void bounds(float low, float high, float size, out ivec4 corners, out vec4 weights) {
  vec2 edge = clamp(vec2(low, high), vec2(0.0), vec2(size));
  ivec2 whole = ivec2(floor(edge));
  vec2 part = edge - vec2(whole);
  corners = min(ivec4(whole.x, whole.x + 1, whole.y, whole.y + 1), ivec4(int(size)));
  weights = vec4(part.x - 1.0, -part.x, 1.0 - part.y, part.y);
}

float lit(uint map_image, MapSample at, FilterParams params) {
  ivec4 xs, ys;
  vec4 across, down;
  // A square across the map's edge shrinks to what lies within, around the point, so that its middle stays the point.
  vec2 middle = clamp(at.uv * at.size, vec2(0.5), vec2(at.size - 0.5));
  vec2 half_width = min(vec2(0.5 * params.width), max(min(middle, at.size - middle), vec2(0.5)));
  bounds(middle.x - half_width.x, middle.x + half_width.x, at.size, xs, across);
  bounds(middle.y - half_width.y, middle.y + half_width.y, at.size, ys, down);
  uvec2 first_row[4];
  for (int i = 0; i < 4; ++i) first_row[i] = table_at(map_image, at.layer, ivec2(xs[i], ys[0]));
  // Since the weights add up to 0, each sum may be taken from the first row and column on: those differences are small and
  // exact.
  vec2 sum = vec2(0.0);
  for (int j = 1; j < 4; ++j) {
    uvec2 first = table_at(map_image, at.layer, ivec2(xs[0], ys[j]));
    for (int i = 1; i < 4; ++i) {
      uvec2 rectangle = table_at(map_image, at.layer, ivec2(xs[i], ys[j])) - first - first_row[i] + first_row[0];
      sum += across[i] * down[j] * vec2(rectangle);
    }
  }
  vec2 moments = sum / (4.0 * half_width.x * half_width.y) / float(1u << savsm_bits(params.width));
  // Both about the middle of the range, in units of half of it.
  float receiver = 2.0 * clamp(at.linear, 0.0, 1.0) - 1.0;
  float least = 2.0 * params.min_variance * 0.01 / at.depth_range_m;
  // Rounding of the stored squares: half a step each.
  float rounding = 1.0 / float(1u << savsm_bits(params.width));
  return reduce_bleeding(chebyshev(2.0 * moments.x - 1.0, moments.y, receiver, least * least + rounding), params.bleeding);
}
