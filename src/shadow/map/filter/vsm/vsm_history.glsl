vec4 with_depth_changed(vec4 stored, float scale, float offset, vec2 depth_range_m, FilterParams params) {
  return vec4(scale * stored.x + offset, scale * scale * stored.y + 2.0 * scale * offset * stored.x + offset * offset, 0.0,
              0.0);
}
