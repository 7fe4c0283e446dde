// Bilinear reading by hand, for what the texture unit cannot average.
#ifndef GNOMON_BILINEAR_GLSL
#define GNOMON_BILINEAR_GLSL

// The four texels around uv and their bilinear weights.
void bilinear_taps(vec2 uv, float size, out ivec2 texels[4], out float weights[4]) {
  vec2 position = uv * size - 0.5;
  ivec2 low = ivec2(floor(position)), last = ivec2(int(size) - 1);
  vec2 high = position - floor(position);
  for (int i = 0; i < 4; ++i) {
    texels[i] = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), last);
    weights[i] = ((i & 1) != 0 ? high.x : 1.0 - high.x) * ((i >> 1) != 0 ? high.y : 1.0 - high.y);
  }
}

#endif
