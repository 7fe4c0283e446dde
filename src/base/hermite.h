// Hermite's cubic.
#pragma once

namespace gnomon {

// The cubic from a (t = 0) to b (t = 1) with these slopes there, per t.
template <class T>
T hermite(const T& a, const T& slope_a, const T& b, const T& slope_b, float t) {
  const float t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * slope_a + (3 * t2 - 2 * t3) * b + (t3 - t2) * slope_b;
}

}  // namespace gnomon
