// Which points count for which sample, and their mean.
#include "reference/cpu/pixel_visibility.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "reference/cpu/confidence.h"

namespace gnomon {

std::vector<vec2> subpixel_places(int count) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  if (count < 1 || side * side != count) {
    const int below = std::max(static_cast<int>(std::sqrt(static_cast<double>(std::max(count, 1)))), 1);
    fail_usage("reference.pixel_samples={}: the points of a pixel form a square; valid: {} or {}", count, below * below,
               (below + 1) * (below + 1));
  }
  std::vector<vec2> places;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) places.push_back((vec2(x, y) + 0.5f) / static_cast<float>(side) - 0.5f);
  }
  return places;
}

PixelAverage::PixelAverage(std::vector<SurfacePoint> points, std::vector<SurfaceSample> surface, std::vector<uint8_t> receiver,
                           uint32_t per_pixel)
    : points_(std::move(points)),
      surface_(std::move(surface)),
      receiver_(std::move(receiver)),
      per_pixel_(per_pixel),
      sums_(points_.size()) {
  GNOMON_ASSERT(surface_.size() == points_.size() && receiver_.size() == points_.size() && points_.size() % per_pixel_ == 0);
}

void PixelAverage::add(std::span<const SurfacePoint> points, std::span<const SurfaceSample> surface,
                       const ReferenceResult& answer, int rays) {
  GNOMON_ASSERT(points.size() * per_pixel_ == points_.size() && surface.size() == points.size());
  ++added_;
  for (size_t i = 0; i < points_.size(); ++i) {
    const size_t other = i / per_pixel_;
    if (!receiver_[i] || !answer.receiver[other]) continue;
    if (!same_surface(surface_[i], surface[other], points[other].position_ws - points_[i].position_ws)) continue;
    const float v = answer.visibility[other];
    sums_[i].visibility += v;
    sums_[i].variance += rays > 1 ? visibility_variance(v, rays) : 0.0f;
    ++sums_[i].count;
  }
}

PixelVisibility PixelAverage::finish() const {
  PixelVisibility pixel;
  ReferenceResult& result = pixel.result;
  result.visibility.resize(points_.size());
  result.receiver.resize(points_.size());
  std::vector<float> variance(points_.size());
  const auto enough = static_cast<uint32_t>(std::max(1, (added_ + 3) / 4));
  size_t receivers = 0, uncovered = 0;
  for (size_t i = 0; i < points_.size(); ++i) {
    if (!receiver_[i]) continue;
    ++receivers;
    const Sum& sum = sums_[i];
    if (sum.count < enough) {
      ++uncovered;
      continue;
    }
    const auto n = static_cast<float>(sum.count);
    result.receiver[i] = 1;
    result.visibility[i] = sum.visibility / n;
    // Of which of the pixel's points the answers are, as if they were drawn at random (squares do better); and of each answer's
    // rays.
    variance[i] = visibility_variance(result.visibility[i], static_cast<int>(sum.count)) + sum.variance / (n * n);
  }
  pixel.uncovered = receivers > 0 ? static_cast<double>(uncovered) / static_cast<double>(receivers) : 0.0;
  result.confidence = mean_confidence(points_, variance, result.receiver);
  return pixel;
}

}  // namespace gnomon
