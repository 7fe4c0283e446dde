// The mean of size x size comparisons, one texel apart. (Reeves, Salesin and Cook 1987)
float compare_texel(uint map_image, MapSample at, vec2 uv) {
  ivec2 texel = ivec2(floor(uv * at.size));
  // Outside the map is lit.
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(int(at.size))))) return 1.0;
  float receiver = min(at.depth + dot(at.depth_gradient, (vec2(texel) + 0.5) / at.size - at.uv), 1.0);
  return texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texel, at.layer), 0).x >= receiver ? 1.0 : 0.0;
}

// Four texels around uv, each less than a texel away, are compared with one receiver depth by the hardware. The plane varies by up
// to a texel of its gradient among them: staying below all four costs that much detachment and no acne.
float compare_bilinear(uint map_image, MapSample at, vec2 uv) {
  float receiver = min(at.depth + dot(at.depth_gradient, uv - at.uv), 1.0);
  float slack = (abs(at.depth_gradient.x) + abs(at.depth_gradient.y)) / at.size;
  return texture(sampler2DArrayShadow(images_2d_array[nonuniformEXT(map_image)], shadow_samplers[k_sampler_compare_linear]),
                 vec4(uv, float(at.layer), receiver - slack));
}

float lit(uint map_image, MapSample at, FilterParams params) {
  float first = -0.5 * float(params.size - 1);
  float sum = 0.0;
  for (int y = 0; y < params.size; ++y) {
    for (int x = 0; x < params.size; ++x) {
      vec2 uv = at.uv + (vec2(x, y) + first) / at.size;
      sum += params.bilinear != 0u ? compare_bilinear(map_image, at, uv) : compare_texel(map_image, at, uv);
    }
  }
  return sum / float(params.size * params.size);
}

float filter_radius(FilterParams params) { return 0.5 * float(params.size) + (params.bilinear != 0u ? 0.5 : 0.0); }
