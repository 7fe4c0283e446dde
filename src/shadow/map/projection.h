// A projection decides where the light's texels go: it yields views to render, and in GLSL the layers that hold a point
// (shadow/map/glsl/visibility.glsl).
#pragma once

#include <span>
#include <vector>

#include "base/params.h"
#include "frame/frame.h"
#include "shadow/map/glsl/map_data.glsl"

namespace gnomon {

class Projection {
 public:
  virtual ~Projection() = default;
  virtual void set(const ParamBlock& params) = 0;

  // Constant between rebuilds.
  virtual uint32_t map_size() const = 0;  // texels along a side
  virtual uint32_t layers() const = 0;
  virtual bool depth_clamp() const = 0;

  // The views of this frame, one per layer.
  virtual std::vector<ShadowView> views(const Frame& frame, const Light& light) const = 0;
};

}  // namespace gnomon
