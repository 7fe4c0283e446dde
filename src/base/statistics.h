// Order statistics of repeated measurements.
#pragma once

#include <span>

namespace gnomon {

// Median, 95th percentile (nearest rank) and median absolute deviation, in the unit of the samples.
struct Summary {
  double median = 0.0;
  double p95 = 0.0;
  double mad = 0.0;
};

// Of at least one sample; the order of the samples does not matter.
Summary summarise(std::span<const double> samples);

}  // namespace gnomon
