// Encodes the depth map and blurs it: a work group loads a tile with an apron of the radius, encodes it into shared memory, blurs rows,
// then columns, and writes each texel once. The includer has defined
//   #define MOMENTS float | vec2 | vec3 | vec4           what a texel stores
//   MOMENTS encode(float linear, vec2 slope, float depth_range_m, FilterParams params)
//                                                        linear depth [0, 1]; its change from this texel to the next; metres from 0 to 1
//   vec4 stored(MOMENTS blurred, FilterParams params)    what goes into the image
// and optionally
//   #define MOMENTS_NEED_SLOPE                           slope is then filled (it costs two more reads)
//   #define MOMENTS_LOG                                  MOMENTS is a float that holds a logarithm: exponentials are summed
//   #define MOMENTS_PREFILTER(params)                    true: a texel holds the mean of itself and its neighbours ahead (2 x 2), before
//                                                        the blur; the reader then looks half a texel back
layout(buffer_reference, scalar) readonly buffer FilterParamsRef { FilterParams v; };
layout(push_constant, scalar) uniform Push {
  ShadowViews views;
  FilterParamsRef map_filter;
  uint depth_image, target, size, unused;
  float weights[11];
};
layout(constant_id = 0) const uint k_samples = 1;
layout(constant_id = 1) const int k_radius = 0;
layout(constant_id = 2) const int k_tile = 32;
layout(constant_id = 3) const bool k_depth_tile = false;  // see MomentMap::uses_depth_tile
layout(local_size_x = 256) in;

const int k_side = k_tile + 2 * k_radius;
shared MOMENTS encoded[k_radius == 0 ? 1 : k_side * k_side];
shared MOMENTS rows[k_radius == 0 ? 1 : k_tile * k_side];
#if defined(MOMENTS_NEED_SLOPE) || defined(MOMENTS_PREFILTER)
// Linear depths of the tile, its apron and one texel more: encoding looks at neighbours.
#define MOMENTS_DEPTH_TILE
const int k_depth_side = k_side + 3;
shared float depths[k_depth_tile ? k_depth_side * k_depth_side : 1];
#endif

// Read once: the same for every texel of the group.
vec4 numerator, denominator;
float depth_range_m;
FilterParams filter_params;
ivec2 tile_origin;
uint layer;

float fetch_linear(ivec2 texel, int s) {
  ivec2 inside = clamp(texel, ivec2(0), ivec2(int(size) - 1));
  float depth = k_samples == 1u ? texelFetch(images_2d_array[depth_image], ivec3(inside, layer), 0).x
                                : texelFetch(images_2d_ms_array[depth_image], ivec3(inside, layer), s).x;
  return clamp(linear_depth(numerator, denominator, (vec2(inside) + 0.5) / float(size), depth), 0.0, 1.0);
}

float linear_at(ivec2 texel, int s) {
#ifdef MOMENTS_DEPTH_TILE
  if (k_depth_tile) {
    ivec2 at = texel - tile_origin + k_radius + 1;
    return depths[at.y * k_depth_side + at.x];
  }
#endif
  return fetch_linear(texel, s);
}

// Of what MOMENTS stands for.
#ifdef MOMENTS_LOG
#define SUM(a, b) (max(a, b) + log(1.0 + exp(-abs((a) - (b)))))
#define MEAN(sum, count) ((sum) - log(float(count)))
#else
#define SUM(a, b) ((a) + (b))
#define MEAN(sum, count) ((sum) / float(count))
#endif

MOMENTS encode_samples(ivec2 texel) {
  MOMENTS sum;
  for (int s = 0; s < int(k_samples); ++s) {
    float z = linear_at(texel, s);
    vec2 slope = vec2(0.0);
#ifdef MOMENTS_NEED_SLOPE
    // Against a silhouette the smaller difference of the two sides is the surface's own.
    vec2 ahead = vec2(linear_at(texel + ivec2(1, 0), s), linear_at(texel + ivec2(0, 1), s)) - z;
    vec2 behind = z - vec2(linear_at(texel - ivec2(1, 0), s), linear_at(texel - ivec2(0, 1), s));
    slope = mix(ahead, behind, lessThan(abs(behind), abs(ahead)));
#endif
    MOMENTS one = encode(z, slope, depth_range_m, filter_params);
    sum = s == 0 ? one : SUM(sum, one);
  }
  return MEAN(sum, k_samples);
}

MOMENTS encode_texel(ivec2 texel) {
  MOMENTS sum = encode_samples(texel);
#ifdef MOMENTS_PREFILTER
  if (MOMENTS_PREFILTER(filter_params)) {
    for (int i = 1; i < 4; ++i) sum = SUM(sum, encode_samples(texel + ivec2(i & 1, i >> 1)));
    sum = MEAN(sum, 4);
  }
#endif
  return sum;
}

// The weighted sum of 2 radius + 1 entries `stride` apart.
#ifdef MOMENTS_LOG
// sum w exp(x) = exp(m) sum w exp(x - m), m the largest x: no exponential leaves the range of floats, however far apart the entries.
#define BLUR(source, middle, stride, result)                                                                         \
  {                                                                                                                  \
    float most = source[middle];                                                                                     \
    for (int i = 1; i <= k_radius; ++i) most = max(most, max(source[middle - i * (stride)], source[middle + i * (stride)])); \
    result = weights[0] * exp(source[middle] - most);                                                                \
    for (int i = 1; i <= k_radius; ++i) {                                                                            \
      result += weights[i] * (exp(source[middle - i * (stride)] - most) + exp(source[middle + i * (stride)] - most)); \
    }                                                                                                                \
    result = most + log(result);                                                                                     \
  }
#else
#define BLUR(source, middle, stride, result)                                                                   \
  {                                                                                                            \
    result = weights[0] * source[middle];                                                                      \
    for (int i = 1; i <= k_radius; ++i) result += weights[i] * (source[middle - i * (stride)] + source[middle + i * (stride)]); \
  }
#endif

void main() {
  layer = gl_WorkGroupID.z;
  if (views.v[layer].raster.in_use == 0u) return;
  numerator = views.v[layer].linear_numerator;
  denominator = views.v[layer].linear_denominator;
  depth_range_m = views.v[layer].depth_range_m;
  filter_params = map_filter.v;
  tile_origin = ivec2(gl_WorkGroupID.xy) * k_tile;
  int lane = int(gl_LocalInvocationIndex);
#ifdef MOMENTS_DEPTH_TILE
  if (k_depth_tile) {
    ivec2 first = tile_origin - k_radius - 1;
    for (int i = lane; i < k_depth_side * k_depth_side; i += 256) depths[i] = fetch_linear(first + ivec2(i % k_depth_side, i / k_depth_side), 0);
    barrier();
  }
#endif
  if (k_radius == 0) {
    for (int i = lane; i < k_tile * k_tile; i += 256) {
      ivec2 texel = tile_origin + ivec2(i % k_tile, i / k_tile);
      if (all(lessThan(texel, ivec2(size)))) imageStore(storage_images[target], ivec3(texel, layer), stored(encode_texel(texel), filter_params));
    }
    return;
  }
  for (int i = lane; i < k_side * k_side; i += 256) encoded[i] = encode_texel(tile_origin - k_radius + ivec2(i % k_side, i / k_side));
  barrier();
  for (int i = lane; i < k_tile * k_side; i += 256) {
    int middle = (i / k_tile) * k_side + i % k_tile + k_radius;
    MOMENTS result;
    BLUR(encoded, middle, 1, result)
    rows[i] = result;
  }
  barrier();
  for (int i = lane; i < k_tile * k_tile; i += 256) {
    ivec2 texel = tile_origin + ivec2(i % k_tile, i / k_tile);
    int middle = (i / k_tile + k_radius) * k_tile + i % k_tile;
    MOMENTS result;
    BLUR(rows, middle, k_tile, result)
    if (all(lessThan(texel, ivec2(size)))) imageStore(storage_images[target], ivec3(texel, layer), stored(result, filter_params));
  }
}
