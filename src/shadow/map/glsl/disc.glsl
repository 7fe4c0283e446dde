// Points of the unit disc at which wide kernels look.
#ifndef GNOMON_DISC_GLSL
#define GNOMON_DISC_GLSL

const uint k_poisson_points = 64u;
// No two of the first n points are near each other, for any n: each is the best of 2000 random candidates, by its distance to
// those before it and twice that to the rim (best candidate, Mitchell 1991).
const vec2 k_poisson[k_poisson_points] = vec2[](
    vec2(0.0741, -0.0312), vec2(-0.6738, -0.0779), vec2(-0.3185, 0.5962), vec2(-0.2608, -0.6427),
    vec2(0.4023, 0.5755), vec2(0.7215, -0.0615), vec2(0.3750, -0.6112), vec2(-0.7025, 0.3739),
    vec2(-0.3026, 0.1618), vec2(-0.6537, -0.4947), vec2(0.0653, 0.8350), vec2(0.7627, 0.3595),
    vec2(0.0574, 0.3740), vec2(0.4197, 0.1805), vec2(-0.3017, -0.2457), vec2(0.0515, -0.4192),
    vec2(0.7286, -0.4647), vec2(0.0602, -0.8583), vec2(0.3912, -0.2544), vec2(-0.5989, 0.6579),
    vec2(-0.8931, 0.1311), vec2(-0.2200, 0.8707), vec2(-0.5164, -0.7308), vec2(-0.8618, -0.2978),
    vec2(0.3533, 0.8426), vec2(0.6723, 0.6057), vec2(0.8945, 0.1362), vec2(-0.0546, 0.6104),
    vec2(-0.5636, 0.1565), vec2(0.8858, -0.2615), vec2(0.6175, -0.6837), vec2(0.3000, -0.8758),
    vec2(-0.1894, 0.3901), vec2(-0.1902, -0.8936), vec2(-0.4593, 0.4062), vec2(-0.1579, -0.0547),
    vec2(-0.4417, -0.0546), vec2(-0.5299, -0.2824), vec2(0.4881, -0.0414), vec2(0.2899, 0.3712),
    vec2(0.1304, -0.6352), vec2(-0.0642, 0.1684), vec2(0.1752, 0.5921), vec2(0.5389, 0.3889),
    vec2(-0.1768, -0.4344), vec2(0.2055, 0.1655), vec2(0.6450, 0.1473), vec2(-0.4413, 0.8225),
    vec2(0.6086, -0.2501), vec2(-0.4205, -0.4812), vec2(0.1797, -0.2321), vec2(-0.9311, -0.0781),
    vec2(0.4962, -0.4451), vec2(-0.0680, -0.2501), vec2(0.2564, -0.4207), vec2(0.2894, -0.0377),
    vec2(0.5343, 0.7511), vec2(-0.0661, -0.6456), vec2(0.9408, -0.0482), vec2(-0.7745, 0.5471),
    vec2(0.4821, -0.8133), vec2(-0.8946, 0.3055), vec2(-0.3732, -0.8598), vec2(-0.0676, 0.9477));

vec2 poisson_point(int i) { return k_poisson[uint(i) % k_poisson_points]; }

// Point i of n on a spiral of equal areas: each turns by the golden angle (Vogel 1979).
vec2 vogel_point(int i, int n) {
  float angle = 2.39996323 * float(i);
  return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(angle), sin(angle));
}

mat2 disc_turn(float share) {
  float angle = 6.28318531 * share;
  return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

#endif
