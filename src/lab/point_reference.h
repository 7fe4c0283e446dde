// What is right at single points, traced on the CPU at once: for a picked pixel, without waiting for a whole picture.
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "reference/cpu/embree_reference.h"

namespace gnomon {

class PointReference {
 public:
  struct Answer {
    float hard, area;  // the ray to the light's centre; the light's real size
  };

  // Builds the acceleration structure in a thread of its own. Keeps a reference to the scene.
  explicit PointReference(const Scene& scene);
  ~PointReference();  // waits for that thread
  PointReference(const PointReference&) = delete;
  PointReference& operator=(const PointReference&) = delete;

  bool ready() const;
  // nullopt until it is ready; then within a millisecond. Throws what the build threw.
  std::optional<Answer> answer(const SurfacePoint& point, const vec3& eye_ws, const Light& light);

 private:
  std::future<std::unique_ptr<EmbreeReference>> building_;
  std::unique_ptr<EmbreeReference> reference_;
};

}  // namespace gnomon
