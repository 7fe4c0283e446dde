// How far the reference's own sampling can move a mean.
#include "reference/cpu/confidence.h"

#include <cmath>

namespace gnomon {

float visibility_variance(float visibility, int samples) {
  return samples > 1 ? visibility * (1.0f - visibility) / static_cast<float>(samples - 1) : 0.25f;
}

double mean_confidence(std::span<const SurfacePoint> points, std::span<const float> variance,
                       std::span<const uint8_t> receiver) {
  double sum_of_variances = 0.0, pixel_deviation = 0.0;
  size_t receivers = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].pixel != points[i - 1].pixel) {
      sum_of_variances += pixel_deviation * pixel_deviation;
      pixel_deviation = 0.0;
    }
    pixel_deviation += std::sqrt(static_cast<double>(variance[i]));
    receivers += receiver[i];
  }
  sum_of_variances += pixel_deviation * pixel_deviation;
  return receivers > 0 ? 1.96 * std::sqrt(sum_of_variances) / static_cast<double>(receivers) : 0.0;
}

}  // namespace gnomon
