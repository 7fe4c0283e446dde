// Polynomials instead of the C library; hashes from base/glsl/sampling.glsl.
#include "scene/builtin/parts/noise.h"

#include <algorithm>
#include <cmath>

#include "base/glsl/sampling.glsl"

namespace gnomon {
namespace {

constexpr double k_half_pi = 1.57079632679489661923;

// Taylor series; the first omitted term is below 1e-16 on [-pi/4, pi/4].
double small_sine(double x) {
  const double x2 = x * x;
  return x * (1 + x2 * (-1.0 / 6 +
                        x2 * (1.0 / 120 + x2 * (-1.0 / 5040 +
                                                x2 * (1.0 / 362880 + x2 * (-1.0 / 39916800 + x2 * (1.0 / 6227020800.0 -
                                                                                                   x2 / 1307674368000.0)))))));
}

double small_cosine(double x) {
  const double x2 = x * x;
  return 1 + x2 * (-1.0 / 2 +
                   x2 * (1.0 / 24 +
                         x2 * (-1.0 / 720 + x2 * (1.0 / 40320 + x2 * (-1.0 / 3628800 + x2 * (1.0 / 479001600.0 +
                                                                                             x2 * (-1.0 / 87178291200.0 +
                                                                                                   x2 / 20922789888000.0)))))));
}

// sin(radians + quarters * pi / 2)
double sine_of_quarters(double radians, int64_t quarters) {
  const double nearest = std::floor(radians / k_half_pi + 0.5);
  const double rest = radians - nearest * k_half_pi;
  switch ((static_cast<int64_t>(nearest) + quarters) & 3) {
    case 0:
      return small_sine(rest);
    case 1:
      return small_cosine(rest);
    case 2:
      return -small_sine(rest);
    default:
      return -small_cosine(rest);
  }
}

// Perlin's quintic: zero first and second derivative at both ends.
template <class T>
T fade(T t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

template <class T>
T lerp(T a, T b, T t) {
  return a + (b - a) * t;
}

double cell_value(int x, int y, int z, uint32_t seed) { return unit_float(hash_cell(x, y, z, seed)); }

}  // namespace

double sine(double radians) { return sine_of_quarters(radians, 0); }

double cosine(double radians) { return sine_of_quarters(radians, 1); }

glm::dvec2 unit_circle(double radians) { return {cosine(radians), sine(radians)}; }

double radians_of(double degrees) { return degrees * (k_half_pi / 90.0); }

mat4 rotation(const vec3& axis, double radians) {
  const glm::dvec3 a(axis);
  const double c = cosine(radians), s = sine(radians);
  const auto column = [&](const glm::dvec3& e) {
    return vec4(vec3(e * c + glm::cross(a, e) * s + a * (glm::dot(a, e) * (1 - c))), 0);
  };
  return mat4(column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}), vec4(0, 0, 0, 1));
}

mat4 translation(const vec3& offset) {
  mat4 result(1.0f);
  result[3] = vec4(offset, 1.0f);
  return result;
}

// One round over a linear mix (primes of Teschner et al. 2003): noise asks for hundreds of millions of these.
uint32_t hash_cell(int x, int y, int z, uint32_t seed) {
  return hash_uint(static_cast<uint32_t>(x) * 73856093u ^ static_cast<uint32_t>(y) * 19349663u ^
                   static_cast<uint32_t>(z) * 83492791u ^ seed * 2654435761u);
}

float unit_random(int x, int y, uint32_t seed) { return unit_float(hash_cell(x, y, 0, seed)); }

float Random::unit() {
  state_ += 0x9e3779b9u;
  return unit_float(hash_uint(state_));
}

vec3 Random::on_sphere() {
  const float y = range(-1.0f, 1.0f);
  const float r = std::sqrt(std::max(0.0f, 1.0f - y * y));
  const vec2 around(unit_circle(2.0 * k_pi * unit()));
  return {r * around.x, y, r * around.y};
}

float tiling_noise(float x, float y, ivec2 period, uint32_t seed) {
  const float floor_x = std::floor(x), floor_y = std::floor(y);
  const auto wrapped = [](int cell, int count) { return ((cell % count) + count) % count; };
  const int x0 = wrapped(static_cast<int>(floor_x), period.x), y0 = wrapped(static_cast<int>(floor_y), period.y);
  const int x1 = wrapped(x0 + 1, period.x), y1 = wrapped(y0 + 1, period.y);
  const float tx = fade(x - floor_x), ty = fade(y - floor_y);
  return lerp(lerp(unit_random(x0, y0, seed), unit_random(x1, y0, seed), tx),
              lerp(unit_random(x0, y1, seed), unit_random(x1, y1, seed), tx), ty);
}

double noise(const glm::dvec3& point, uint32_t seed) {
  const glm::dvec3 base = glm::floor(point);
  const glm::dvec3 f = point - base;
  const int x = static_cast<int>(base.x), y = static_cast<int>(base.y), z = static_cast<int>(base.z);
  const double tx = fade(f.x), ty = fade(f.y), tz = fade(f.z);
  const auto plane = [&](int cz) {
    return lerp(lerp(cell_value(x, y, cz, seed), cell_value(x + 1, y, cz, seed), tx),
                lerp(cell_value(x, y + 1, cz, seed), cell_value(x + 1, y + 1, cz, seed), tx), ty);
  };
  return lerp(plane(z), plane(z + 1), tz);
}

float tiling_fractal(float u, float v, ivec2 period, int octaves, uint32_t seed) {
  float sum = 0.0f, weight = 0.0f, amplitude = 1.0f;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.5f, period *= 2) {
    const vec2 at = vec2(u, v) * vec2(period);
    sum += amplitude * tiling_noise(at.x, at.y, period, seed + static_cast<uint32_t>(i));
    weight += amplitude;
  }
  return sum / weight;
}

double fractal(const glm::dvec3& point, int octaves, uint32_t seed) {
  double sum = 0.0, weight = 0.0, amplitude = 1.0, scale = 1.0;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.5, scale *= 2.0) {
    sum += amplitude * noise(point * scale, seed + static_cast<uint32_t>(i));
    weight += amplitude;
  }
  return sum / weight;
}

float smooth_step(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace gnomon
