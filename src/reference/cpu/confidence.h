// How far the reference's own sampling can move a mean: the same for both tracers.
#pragma once

#include <cstdint>
#include <span>

#include "scene/surface_point.h"

namespace gnomon {

// Squared standard error of one point's visibility from `samples` rays toward a light with size. p (1 - p) / (n - 1) is
// unbiased for independent samples; the scrambled sequence does better, by how much is not known. One sample says nothing about
// its variance: at most 1/4.
float visibility_variance(float visibility, int samples);

// 95 % half-width of the mean over receivers. Pixels are scrambled independently; samples of one pixel share their sequence, so
// their errors may all point one way: standard errors add within a pixel, variances between pixels.
double mean_confidence(std::span<const SurfacePoint> points, std::span<const float> variance,
                       std::span<const uint8_t> receiver);

}  // namespace gnomon
