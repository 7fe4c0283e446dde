// Embree, in the background.
#include "lab/explain/point_reference.h"

#include <chrono>

namespace gnomon {
namespace {

// The error of an edge's visibility is then at most 0.03, below what counts as wrong.
constexpr int k_samples = 256;

}  // namespace

PointReference::PointReference(SharedReference& rays)
    : building_(std::async(std::launch::async, [&rays] { return &rays.get(); })) {}

PointReference::~PointReference() {
  if (building_.valid()) building_.wait();
}

bool PointReference::ready() const {
  return reference_ || (building_.valid() && building_.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
}

std::optional<PointReference::Answer> PointReference::answer(const SurfacePoint& point, const vec3& eye_ws,
                                                             const Light& light) {
  if (!ready()) return std::nullopt;
  if (!reference_) reference_ = building_.get();
  // A scene without casters has no shadow.
  if (reference_->triangle_count() == 0) return Answer{1.0f, 1.0f};
  const auto trace = [&](bool area) {
    return reference_->trace(std::span(&point, 1), eye_ws, light, area, k_samples, 1).visibility[0];
  };
  return Answer{trace(false), trace(true)};
}

}  // namespace gnomon
