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
  virtual uint32_t layers() const = 0;    // at most k_max_layers
  // Casters before a view's near plane are drawn onto it; not under a projector, where they may stand behind the light.
  virtual bool depth_clamp() const { return false; }
  // All views are paraboloids, and casters are drawn without bending (CasterDrawOptions::paraboloid).
  virtual bool exact_paraboloid() const { return false; }

  // The views of this frame: at most layers(); fewer where this frame needs fewer. They see every caster that can shadow a
  // visible point (a projection that computes its views on the GPU gives a safe first guess here).
  virtual std::vector<ShadowView> views(const Frame& frame, const Light& light) const = 0;
  // For projections that compute views on the GPU: passes that overwrite `views` (a ShadowMapData, then ShadowViews; device
  // address in the buffer), from the surface buffer.
  virtual bool on_gpu() const { return false; }
  virtual void record_views(Recorder& /*recorder*/, const Frame& /*frame*/, const Light& /*light*/, const Buffer& /*views*/) {}
};

}  // namespace gnomon
