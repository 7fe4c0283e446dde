// The exponent over the whole range of depths, as the map is written and read.
float esm_exponent(float c, uint unit, uint space, float depth_range_m) {
  float exponent = unit == unit_metre ? c * depth_range_m : c;
  // exp(+-80) is a normal float, with room for a product. A logarithm of 1e5 has steps of 0.008: beyond, the edges would be
  // coarse.
  return min(exponent, space == space_exponential ? 160.0 : 1e5);
}
