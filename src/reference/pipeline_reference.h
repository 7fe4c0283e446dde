// Ray-traced truth on the GPU: the same points and rays as reference/cpu/embree_reference.h, through the ray-tracing pipeline.
#pragma once

#include "frame/frame.h"
#include "frame/rays/acceleration_structure.h"
#include "reference/cpu/embree_reference.h"

namespace gnomon {

class PipelineReference {
 public:
  // Throws Error (device) where the device cannot trace rays.
  PipelineReference(Device& device, const AccelerationStructure& structure);

  // As EmbreeReference::trace, for every sample of the frame's surface buffer.
  ReferenceResult trace(const Frame& frame, const Light& light, bool area, int samples, uint32_t seed) const;

 private:
  Device& device_;
  const AccelerationStructure& structure_;
  RayPipeline pipeline_;
};

}  // namespace gnomon
