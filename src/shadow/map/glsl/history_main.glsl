// Blends a moment map with the last frame's, in place. The includer has defined
//   vec4 with_depth_changed(vec4 stored, float scale, float offset, vec2 depth_range_m, FilterParams params)
//        what would be stored if every linear depth z were scale z + offset; depth ranges: of the last map and of this one
layout(buffer_reference, scalar) readonly buffer FilterParamsRef { FilterParams v; };
layout(push_constant, scalar) uniform Push {
  ShadowViews views, last_views;
  FilterParamsRef map_filter;
  uint depth_image, map, last_map, size;
  float history;
};
layout(constant_id = 0) const uint k_samples = 1;       // of the depth map
layout(constant_id = 1) const uint k_logarithms = 0u;   // the map holds logarithms: exponentials are averaged
layout(local_size_x = 8, local_size_y = 8) in;

vec4 mean_of(vec4 a, vec4 b, float share_of_b) {
  if (k_logarithms == 0u) return mix(a, b, share_of_b);
  vec4 most = max(a, b);
  return most + log(mix(exp(a - most), exp(b - most), share_of_b));
}

vec4 last_at(vec2 uv, uint layer) {
  ivec2 texels[4];
  float weights[4];
  bilinear_taps(uv, float(size), texels, weights);
  vec4 values[4], most = vec4(-1e30), sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    values[i] = texelFetch(images_2d_array[last_map], ivec3(texels[i], layer), 0);
    if (weights[i] > 1e-6) most = max(most, values[i]);
  }
  if (k_logarithms == 0u)
    return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2] + weights[3] * values[3];
  for (int i = 0; i < 4; ++i) sum += weights[i] > 1e-6 ? weights[i] * exp(values[i] - most) : vec4(0.0);
  return most + log(sum);
}

// The last map where it held the surface that this one has at (uv, depth), in this map's units. False where it saw none.
bool last_moments(ShadowView now, ShadowView before, vec2 uv, uint layer, float depth, out vec4 found) {
  vec3 there, here[2];
  if (!seen_from(now, before, vec3(uv, depth), there)) return false;
  // Linear depths of both maps are in proportion to metres along that texel's ray: two points of it say how.
  vec2 linear_before, linear_now;
  for (int end = 0; end < 2; ++end) {
    vec3 place = vec3(there.xy, float(end));
    seen_from(before, now, place, here[end]);
    linear_before[end] = linear_depth(before.linear_numerator, before.linear_denominator, place.xy, place.z);
    linear_now[end] = linear_depth(now.linear_numerator, now.linear_denominator, here[end].xy, here[end].z);
  }
  float scale = (linear_now[1] - linear_now[0]) / (linear_before[1] - linear_before[0]);
  float offset = linear_now[0] - scale * linear_before[0];
  found =
      with_depth_changed(last_at(there.xy, layer), scale, offset, vec2(before.depth_range_m, now.depth_range_m), map_filter.v);
  // Views from two sides have nothing in common.
  return scale > 0.0;
}

void main() {
  uint layer = gl_WorkGroupID.z;
  ShadowView now = views.v[layer], before = last_views.v[layer];
  uint kind = history_of(now, before);
  if (kind == k_history_none) return;
  for (uint i = 0u; i < 4u; ++i) {
    ivec3 texel = ivec3(pixel_of_tile(i), layer);
    if (any(greaterThanEqual(texel.xy, ivec2(size)))) continue;
    vec4 found;
    if (kind == k_history_same) {
      found = texelFetch(images_2d_array[last_map], texel, 0);
    } else {
      float depth = k_samples == 1u ? texelFetch(images_2d_array[depth_image], texel, 0).x
                                    : texelFetch(images_2d_ms_array[depth_image], texel, 0).x;
      if (!last_moments(now, before, (vec2(texel.xy) + 0.5) / float(size), layer, depth, found)) continue;
    }
    imageStore(storage_images[map], texel, mean_of(imageLoad(storage_images[map], texel), found, history));
  }
}
