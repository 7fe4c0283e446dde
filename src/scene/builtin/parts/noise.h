// Trigonometry, hashes and noise that give the same bits on every machine: the C library's sin and cos choose their
// instructions by processor, and the standard leaves random distributions open. Only + - * / and sqrt are used; the build
// must not fuse them (-ffp-contract=off where the target has fused multiply-add).
#pragma once

#include <cstdint>

#include "base/maths.h"

namespace gnomon {

// Error below 1e-15 (1 + |radians|).
double sine(double radians);
double cosine(double radians);
// (cos, sin).
glm::dvec2 unit_circle(double radians);
double radians_of(double degrees);

// Rotation by the right-hand rule; axis is unit.
mat4 rotation(const vec3& axis, double radians);
mat4 translation(const vec3& offset);

uint32_t hash_cell(int x, int y, int z, uint32_t seed);
float unit_random(int x, int y, uint32_t seed);  // in [0, 1)

// A sequence of numbers from one seed. One call per expression: compilers differ in the order in which they evaluate operands.
class Random {
 public:
  explicit Random(uint32_t seed) : state_(seed) {}
  float unit();  // in [0, 1)
  float range(float low, float high) { return low + (high - low) * unit(); }
  vec3 on_sphere();

 private:
  uint32_t state_;
};

// Value noise in [0, 1], smooth to the second derivative; `tiling_noise` repeats after `period` units of each axis.
float tiling_noise(float x, float y, ivec2 period, uint32_t seed);
double noise(const glm::dvec3& point, uint32_t seed);

// Octaves of noise, each twice as fine and half as strong, in [0, 1]. The tiling one takes (u, v) in the unit square of a
// texture, with `period` cells of the coarsest octave across it.
float tiling_fractal(float u, float v, ivec2 period, int octaves, uint32_t seed);
double fractal(const glm::dvec3& point, int octaves, uint32_t seed);

// 0 below `low`, 1 above `high`, smooth between.
float smooth_step(float low, float high, float value);

}  // namespace gnomon
