// The mean of many comparisons around a point. (Reeves, Salesin and Cook 1987)
#define GNOMON_FILTER_NOISE
#include "shadow/map/glsl/compare.glsl"
#include "shadow/map/glsl/disc.glsl"

float compare(uint map_image, MapSample at, FilterParams params, vec2 uv) {
  return params.bilinear != 0u ? compare_bilinear(map_image, at, uv) : compare_texel(map_image, at, ivec2(floor(uv * at.size)));
}

// Of comparison i along a side; the tent reaches 0 one step outside the kernel.
float side_weight(FilterParams params, int i) {
  if (i < 0 || i >= params.size) return 0.0;
  if (params.weights == weights_box) return 1.0;
  return 1.0 - abs(2.0 * float(i) - float(params.size - 1)) / float(params.size + 1);
}

float grid(uint map_image, MapSample at, FilterParams params) {
  vec2 first = at.uv - 0.5 * float(params.size - 1) / at.size;
  float sum = 0.0, total = 0.0;
  for (int y = 0; y < params.size; ++y) {
    for (int x = 0; x < params.size; ++x) {
      float weight = side_weight(params, x) * side_weight(params, y);
      sum += weight * compare(map_image, at, params, first + vec2(x, y) / at.size);
      total += weight;
    }
  }
  return sum / total;
}

// Texel i of a side takes part in bilinear comparison i with 1 - part and in the one before with part.
float texel_weight(FilterParams params, int i, float part) {
  return side_weight(params, i) * (1.0 - part) + side_weight(params, i - 1) * part;
}

// The grid's sum, texel by texel: comparisons that share texels are merged, which leaves size + 1 texels a side (size, without
// bilinear), read two by two. Without a plane the sampler compares and weighs the two by two itself: a tap between two texels,
// nearer to the heavier one, gives both their weights (the "optimised PCF" of public samples for 3x3, 5x5 and 7x7, for any
// size).
float optimised(uint map_image, MapSample at, FilterParams params) {
  bool bilinear = params.bilinear != 0u;
  vec2 place = at.uv * at.size - 0.5 * float(params.size - 1) - (bilinear ? 0.5 : 0.0);
  vec2 first = floor(place);
  vec2 part = bilinear ? place - first : vec2(0.0);
  bool plane = has_plane(at);
  int texels = bilinear ? params.size + 1 : params.size;
  float sum = 0.0, total = 0.0;
  for (int y = 0; y < texels; y += 2) {
    vec2 wy = vec2(texel_weight(params, y, part.y), texel_weight(params, y + 1, part.y));
    float row = wy.x + wy.y;
    for (int x = 0; x < texels; x += 2) {
      vec2 wx = vec2(texel_weight(params, x, part.x), texel_weight(params, x + 1, part.x));
      float column = wx.x + wx.y;
      vec2 texel = first + vec2(x, y);
      if (plane) {
        vec4 lit = compare_four(map_image, at, texel);
        sum += wy.x * dot(wx, lit.xy) + wy.y * dot(wx, lit.zw);
      } else if (row * column > 0.0) {
        sum += row * column * compare_sampler(map_image, at, (texel + 0.5 + vec2(wx.y / column, wy.y / row)) / at.size);
      }
      total += row * column;
    }
  }
  return sum / total;
}

float disc(uint map_image, MapSample at, FilterParams params) {
  mat2 turn = disc_turn(params.rotate != 0u ? at.noise.x : 0.0);
  float sum = 0.0, total = 0.0;
  for (int i = 0; i < params.taps; ++i) {
    vec2 offset = turn * (params.kernel == kernel_poisson ? poisson_point(i) : vogel_point(i, params.taps));
    float weight = params.weights == weights_box ? 1.0 : 1.001 - length(offset);
    sum += weight * compare(map_image, at, params, at.uv + offset * (params.radius / at.size));
    total += weight;
  }
  return sum / total;
}

float lit(uint map_image, MapSample at, FilterParams params) {
  if (params.kernel == kernel_grid) return grid(map_image, at, params);
  if (params.kernel == kernel_optimised) return min(optimised(map_image, at, params), 1.0);
  return disc(map_image, at, params);
}

float filter_radius(FilterParams params) {
  float reach = params.kernel <= kernel_optimised ? 0.5 * float(params.size) : params.radius + 0.5;
  return reach + (params.bilinear != 0u ? 0.5 : 0.0);
}
