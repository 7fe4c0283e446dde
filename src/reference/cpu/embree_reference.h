// Ray-traced truth on the CPU: independent of the GPU's implementation (reference/pipeline_reference.h), compared with it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/surface_point.h"

namespace gnomon {

// Visibility of a set of points toward one light.
struct ReferenceResult {
  std::vector<float> visibility;  // one per point: 1 lit, 0 shadowed; 0 where the point is no receiver
  std::vector<uint8_t> receiver;  // 1 where the point shows a surface whose geometric normal faces the light
  double confidence = 0.0;        // half-width of the 95 % interval of the mean visibility over receivers; 0 for hard shadows
};

class EmbreeReference {
 public:
  // Builds the acceleration structure of every casting object, alpha-tested casters included. Keeps a reference to the scene.
  explicit EmbreeReference(const Scene& scene);
  ~EmbreeReference();
  EmbreeReference(const EmbreeReference&) = delete;
  EmbreeReference& operator=(const EmbreeReference&) = delete;

  // Triangles in the acceleration structure, instances counted: must equal what the rasteriser draws as casters.
  size_t triangle_count() const;

  // area = false: one ray to the light's centre. area = true: `samples` rays over the sun's disc or the emitting sphere, from a
  // scrambled (0,2)-sequence (base/glsl/sampling.glsl), scrambled per pixel by `seed`. `eye_ws` is the camera's position, from
  // which the points were reconstructed (their rounding error grows with the distance). Uses all cores; shows progress. The
  // same input gives the same bits, whatever the number of threads. What counts is in base/glsl/light_sampling.glsl. Throws
  // Error with a point that is not finite. Points of one pixel (one after the other) share their sequence.
  ReferenceResult trace(std::span<const SurfacePoint> points, const vec3& eye_ws, const Light& light, bool area, int samples,
                        uint32_t seed) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gnomon
