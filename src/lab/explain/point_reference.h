// What is right at single points, traced on the CPU at once: for a picked pixel, without waiting for a whole picture.
#pragma once

#include <future>
#include <optional>

#include "reference/cpu/shared_reference.h"

namespace gnomon {

class PointReference {
 public:
  struct Answer {
    float hard, area;  // the ray to the light's centre; the light's real size
  };

  // Has the acceleration structure built in a thread of its own, where it is not. Keeps a reference to `rays`.
  explicit PointReference(SharedReference& rays);
  ~PointReference();  // waits for that thread
  PointReference(const PointReference&) = delete;
  PointReference& operator=(const PointReference&) = delete;

  bool ready() const;
  // nullopt until it is ready; then within a millisecond. Throws what the build threw.
  std::optional<Answer> answer(const SurfacePoint& point, const vec3& eye_ws, const Light& light);

 private:
  std::future<const EmbreeReference*> building_;
  const EmbreeReference* reference_ = nullptr;
};

}  // namespace gnomon
