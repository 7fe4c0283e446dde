// Order statistics of repeated measurements.
#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"

namespace gnomon {
namespace {

double median_of_sorted(const std::vector<double>& sorted) {
  const size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace

Summary summarise(std::span<const double> samples) {
  GNOMON_ASSERT(!samples.empty());
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  Summary summary;
  summary.median = median_of_sorted(sorted);
  const auto rank = static_cast<size_t>(std::ceil(0.95 * static_cast<double>(sorted.size())));
  summary.p95 = sorted[std::max<size_t>(rank, 1) - 1];
  for (double& value : sorted) value = std::abs(value - summary.median);
  std::sort(sorted.begin(), sorted.end());
  summary.mad = median_of_sorted(sorted);
  return summary;
}

}  // namespace gnomon
