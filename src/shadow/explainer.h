// Shows what a technique did: overlays over the picture, and everything about one pixel. Techniques know nothing of it: it asks
// the same GLSL that they do (shadow/map/glsl/explain_main.glsl).
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "frame/shading/overdraw.h"
#include "shadow/map/glsl/explain_data.glsl"
#include "shadow/technique.h"

namespace gnomon {

// By k_overlay_*: "none", "layers", ...
std::string_view overlay_name(uint32_t overlay);
// Whether an overlay shows something of the map: other techniques have nothing there.
bool overlay_needs_map(uint32_t overlay);

class Explainer {
 public:
  explicit Explainer(Device& device);

  // Blends an overlay into the frame's display: behind Frame::record_shade. `technique` is that of the light, recorded in this
  // frame.
  void record_overlay(Recorder& recorder, const Frame& frame, size_t light, const Technique& technique, uint32_t overlay,
                      float opacity);
  // Asks about a pixel of the frame, and for the map's views; behind the technique's passes. The answers are there once the
  // recorder has finished.
  void record_pick(Recorder& recorder, const Frame& frame, size_t light, const Technique& technique, uvec2 pixel);
  void record_views(Recorder& recorder, const Technique& technique);

  // The shaders may be others now: what is made of them is made again when it is next needed.
  void forget_shaders() { pipelines_.clear(), overdraw_.reset(); }

  PickRecord picked() const;
  // Those that the map uses, none for a technique without one.
  std::vector<ShadowView> views() const;

 private:
  void record(Recorder& recorder, const char* pass, const Frame& frame, size_t light, const std::optional<ShadowMapView>& map,
              ExplainArguments arguments, const Buffer& output);
  const Pipeline& pipeline(const std::string& shader, uint32_t samples);

  Device& device_;
  std::map<std::string, Pipeline> pipelines_;  // by shader and samples
  Buffer radius_, record_, views_;
  bool has_views_ = false;
  std::optional<Overdraw> overdraw_;
};

}  // namespace gnomon
