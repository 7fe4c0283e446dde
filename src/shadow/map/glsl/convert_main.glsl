// Encodes the depth map and blurs it in one pass: a thread marches down a strip of columns, blurs each row, keeps the last
// rows' results in registers and writes their weighted sum, so each texel is encoded about once and written once. A row's
// neighbours come from the other threads of the group through shared memory (k_share: a GPU, where they wait for nothing else),
// or the thread encodes k_columns texels and their apron itself (a CPU, where shared memory and barriers cost more than
// encoding). The includer has defined
//   #define MOMENTS float | vec2 | vec3 | vec4           what a texel stores
//   MOMENTS encode(float linear, vec2 slope, float depth_range_m, FilterParams params)
//                                                        linear depth [0, 1]; its change from this texel to the next; metres
//                                                        from 0 to 1
//   vec4 stored(MOMENTS blurred, FilterParams params)    what goes into the image
// and optionally
//   #define MOMENTS_NEED_SLOPE                           slope is then filled
//   #define MOMENTS_LOG condition                        where true, MOMENTS is a float that holds a logarithm: exponentials
//                                                        are summed
layout(buffer_reference, scalar) readonly buffer FilterParamsRef { FilterParams v; };
layout(push_constant, scalar) uniform Push {
  ShadowViews views;
  FilterParamsRef map_filter;
  uint depth_image, target, size;
  float weights[22];
};
layout(constant_id = 0) const int k_samples = 1;
layout(constant_id = 1) const int k_taps = 1;     // of the kernel, along each axis
layout(constant_id = 2) const int k_before = 0;   // of them before the texel itself
layout(constant_id = 3) const int k_columns = 1;  // that a thread writes
layout(constant_id = 4) const int k_rows = 32;    // that a thread writes
layout(constant_id = 5) const bool k_share = false;
layout(constant_id = 6) const int k_threads = 64;
layout(local_size_x_id = 6) in;

#ifdef MOMENTS_NEED_SLOPE
const int k_margin = 1;  // texels beyond those encoded, whose depths give the slope
#else
const int k_margin = 0;
#endif
const int k_wide = k_columns + k_taps - 1;       // texels of a row that a thread blurs
const int k_own = k_share ? k_columns : k_wide;  // of them, those that it encodes
const int k_kept = k_own + 2 * k_margin;
const int k_row = k_threads * k_columns;         // texels of a row that a group encodes
const int k_stride = k_row + k_wide;  // the last threads read beyond the row, and write nothing
shared MOMENTS shared_row[k_share ? 2 * k_stride : 1];
shared float shared_depth[k_share && k_margin > 0 ? 2 * k_stride : 1];

// Read once: the same for every texel of the group.
vec4 numerator, denominator;  // as ShadowView's, of (texel, depth, 1) instead of (ndc, 1)
bool affine;                  // linear depth is: the denominator is 1
float depth_range_m;
FilterParams filter_params;
uint layer;

vec4 of_texels(vec4 of_ndc) {
  float scale = 2.0 / float(size);
  return vec4(of_ndc.xy * scale, of_ndc.z, of_ndc.w + (0.5 * scale - 1.0) * (of_ndc.x + of_ndc.y));
}

float linear_at(ivec2 texel, int s) {
  ivec2 inside = clamp(texel, ivec2(0), ivec2(int(size) - 1));
  float depth = k_samples == 1 ? texelFetch(images_2d_array[depth_image], ivec3(inside, layer), 0).x
                               : texelFetch(images_2d_ms_array[depth_image], ivec3(inside, layer), s).x;
  // What depends on the column alone first: it stays the same on the way down.
  float linear = (numerator.w + numerator.x * float(inside.x)) + numerator.y * float(inside.y) + numerator.z * depth;
  if (!affine) linear /= dot(denominator, vec4(inside, depth, 1.0));
  return clamp(linear, 0.0, 1.0);
}

#define LINEAR_BLUR(source, first, result)                                                                 \
  {                                                                                                        \
    MOMENTS total = weights[0] * source[first];                                                            \
    for (int tap = 1; tap < k_taps; ++tap) total += weights[tap] * source[(first) + tap];                  \
    result = total;                                                                                        \
  }
#ifdef MOMENTS_LOG
float sum_of(float a, float b) { return MOMENTS_LOG ? max(a, b) + log(1.0 + exp(-abs(a - b))) : a + b; }
float mean_of(float sum, int count) { return MOMENTS_LOG ? sum - log(float(count)) : sum / float(count); }
// sum w exp(x) = exp(m) sum w exp(x - m), m the largest x: no exponential leaves the range of floats, however far apart the
// entries.
#define BLUR(source, first, result)                                                                        \
  if (MOMENTS_LOG) {                                                                                       \
    float most = source[first];                                                                            \
    for (int tap = 1; tap < k_taps; ++tap) most = max(most, source[(first) + tap]);                        \
    float total = 0.0;                                                                                     \
    for (int tap = 0; tap < k_taps; ++tap) total += weights[tap] * exp(source[(first) + tap] - most);      \
    result = most + log(total);                                                                            \
  } else {                                                                                                 \
    LINEAR_BLUR(source, first, result)                                                                     \
  }
#else
MOMENTS sum_of(MOMENTS a, MOMENTS b) { return a + b; }
MOMENTS mean_of(MOMENTS sum, int count) { return sum / float(count); }
#define BLUR(source, first, result) LINEAR_BLUR(source, first, result)
#endif

// Of one sample a texel, depths of the row before, the row itself and the row after stay in registers.
float above[k_kept], here[k_kept], below[k_kept];

MOMENTS encode_texel(ivec2 texel, int i) {
  MOMENTS sum;
  for (int s = 0; s < k_samples; ++s) {
    float z = k_samples == 1 && k_margin > 0 ? here[i] : linear_at(texel, s);
    vec2 slope = vec2(0.0);
#ifdef MOMENTS_NEED_SLOPE
    vec2 before, after;
    if (k_samples == 1) {
      before = vec2(here[i - 1], above[i]);
      after = vec2(here[i + 1], below[i]);
    } else {
      before = vec2(linear_at(texel - ivec2(1, 0), s), linear_at(texel - ivec2(0, 1), s));
      after = vec2(linear_at(texel + ivec2(1, 0), s), linear_at(texel + ivec2(0, 1), s));
    }
    // Against a silhouette the smaller difference of the two sides is the surface's own.
    vec2 ahead = after - z, behind = z - before;
    slope = mix(ahead, behind, lessThan(abs(behind), abs(ahead)));
#endif
    MOMENTS one = encode(z, slope, depth_range_m, filter_params);
    sum = s == 0 ? one : sum_of(sum, one);
  }
  return mean_of(sum, k_samples);
}

void main() {
  layer = gl_WorkGroupID.z;
  if (views.v[layer].raster.in_use == 0u) return;
  numerator = of_texels(views.v[layer].linear_numerator);
  denominator = of_texels(views.v[layer].linear_denominator);
  affine = views.v[layer].linear_denominator == vec4(0.0, 0.0, 0.0, 1.0);
  depth_range_m = views.v[layer].depth_range_m;
  filter_params = map_filter.v;
  int lane = int(gl_LocalInvocationIndex);
  // Texels at the ends of a row that is shared are only encoded; the first and the last do not even see both their neighbours.
  const int k_edge = k_share ? 1 : 0;
  const int written = k_share ? k_row - (k_taps - 1) - 2 * k_edge : k_row;
  int column = lane * k_columns;  // of the group's
  ivec2 first = ivec2(int(gl_WorkGroupID.x) * written + column, int(gl_WorkGroupID.y) * k_rows);
  // The first texel that the thread encodes.
  ivec2 texel = first - k_before - ivec2(k_edge, 0);
  if (k_margin > 0 && k_samples == 1) {
    for (int i = 0; i < k_kept; ++i) {
      here[i] = linear_at(texel + ivec2(i - k_margin, -1), 0);
      below[i] = linear_at(texel + ivec2(i - k_margin, 0), 0);
    }
  }
  float next[k_own];
  if (k_share && k_margin > 0 && k_samples == 1) {
    for (int j = 0; j < k_own; ++j) next[j] = linear_at(texel + ivec2(j, 1), 0);
  }
  MOMENTS window[k_columns * k_taps];  // of each column, the last rows, blurred along the row
  for (int i = 0; i < k_rows + k_taps - 1; ++i, ++texel.y) {
    int shared_column = (i & 1) * k_stride + column;
    if (k_margin > 0 && k_samples == 1) {
      for (int j = 0; j < k_kept; ++j) {
        above[j] = here[j];
        here[j] = below[j];
        if (!k_share) below[j] = linear_at(texel + ivec2(j - k_margin, 1), 0);
      }
    }
    if (k_share && k_margin > 0 && k_samples == 1) {
      // A row ahead: the next one is on its way while this one is worked on.
      for (int j = 0; j < k_own; ++j) {
        below[j + k_margin] = next[j];
        next[j] = linear_at(texel + ivec2(j, 2), 0);
      }
    }
    MOMENTS row[k_wide];
    if (k_share) {
      for (int j = 0; j < k_own; ++j) {
        shared_row[shared_column + j] = encode_texel(texel + ivec2(j, 0), j + k_margin);
        if (k_margin > 0) shared_depth[shared_column + j] = below[j + k_margin];
      }
      barrier();
      for (int j = 0; j < k_wide; ++j) row[j] = shared_row[shared_column + k_edge + j];
      if (k_margin > 0) {
        below[0] = shared_depth[shared_column - (column > 0 ? 1 : 0)];
        below[k_kept - 1] = shared_depth[shared_column + (column + k_own < k_row ? k_own : 0)];
      }
    } else {
      for (int j = 0; j < k_own; ++j) row[j] = encode_texel(texel + ivec2(j, 0), j + k_margin);
    }
    int y = first.y + i - (k_taps - 1);
    for (int c = 0; c < k_columns; ++c) {
      for (int tap = 1; tap < k_taps; ++tap) window[c * k_taps + tap - 1] = window[c * k_taps + tap];
      BLUR(row, c, window[c * k_taps + k_taps - 1])
      MOMENTS result;
      BLUR(window, c * k_taps, result)
      if (column + c < written && y >= first.y && first.x + c < int(size) && y < int(size)) {
        imageStore(storage_images[target], ivec3(first.x + c, y, layer), stored(result, filter_params));
      }
    }
  }
}
