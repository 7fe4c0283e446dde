// The reference of a view that may change at any moment: traced in the background, coarse at first, given up when the view
// moves on.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "reference/cpu/shared_reference.h"

namespace gnomon {

class ProgressiveReference {
 public:
  struct View {
    std::vector<SurfacePoint> points;  // samples of a pixel one after the other
    uint32_t samples_of_pixel = 1;
    vec3 eye_ws = vec3(0.0f);
    std::vector<Light> lights;
    bool area = true;  // lights with their size, where they have one
    int samples = 64;  // of those, in the end
    uint32_t seed = 1;
  };
  struct Answer {
    std::vector<ReferenceResult> lights;  // as EmbreeReference::trace with that many samples
    int samples = 1;                      // rays toward a light with size
    bool complete = false;                // better ones do not follow
  };

  // Keeps a reference to `rays`. `caster_triangles`: as the rasteriser draws them; another number in the structure is an error.
  ProgressiveReference(SharedReference& rays, size_t caster_triangles);
  ~ProgressiveReference();
  ProgressiveReference(const ProgressiveReference&) = delete;
  ProgressiveReference& operator=(const ProgressiveReference&) = delete;

  // Drops what it was doing. The first answer has one ray per point and light; each later one has four times the samples.
  void start(View view);
  void stop();
  // The newest answer that was not taken yet. Throws Error with what tracing threw.
  std::optional<Answer> poll();
  // Of the rays that the complete answer needs, [0, 1].
  double share() const;

 private:
  void work(const std::stop_token& stop);
  void trace(const View& view, uint64_t generation);
  // False when the view is no longer wanted.
  bool trace_light(const EmbreeReference& rays, const View& view, uint64_t generation, size_t light, int samples,
                   ReferenceResult& result);
  bool wanted(uint64_t generation) const;

  SharedReference& rays_of_scene_;
  const size_t caster_triangles_;

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<View> next_;
  uint64_t generation_ = 0;  // of the last start or stop
  std::optional<Answer> answer_;
  std::string error_;
  double rays_done_ = 0.0, rays_ = 1.0;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace gnomon
