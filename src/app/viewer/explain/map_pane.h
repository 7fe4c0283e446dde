// A window that shows a layer of a shadow map: zoom, pan, the value under the pointer.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/viewer/explain/map_pane_data.glsl"
#include "gpu/pipeline.h"
#include "gpu/recorder.h"
#include "shadow/map/glsl/map_texel.glsl"
#include "shadow/map/shadow_map_view.h"

struct ImDrawCmd;
struct ImDrawList;

namespace gnomon::viewer {

class MapPane {
 public:
  // `render_pass`: that the interface is drawn in.
  MapPane(Device& device, VkRenderPass render_pass);

  // Of the shaders as they are now.
  void make_pipelines(VkRenderPass render_pass);

  // Writes the window; `open` is set to false when the user closes it. `map`: of the last frame; `light_name`: whose, empty
  // where there is one alone.
  void show(const std::optional<ShadowMapView>& map, const std::string& light_name, uint32_t& layer, bool& open);
  // Behind the technique's passes: the map of this frame is what will be drawn. nullopt: none.
  void record(Recorder& recorder, const std::optional<ShadowMapView>& map, uint32_t layer);
  // What the pass that draws the interface must name.
  std::span<const ResourceUse> uses() const { return uses_; }

 private:
  enum class Content { depth, filtered, objects };
  void choose(const ShadowMapView& map, uint32_t& layer);
  void show_picture(const Image& image, float scale);
  static void draw(const ImDrawList* list, const ImDrawCmd* command);
  const Image& image_of(const ShadowMapView& map) const;
  MapProbe probe() const;

  Device& device_;
  Pipeline pipeline_, probe_begins_, probe_;
  Buffer result_;
  Content content_ = Content::depth;
  uint32_t channels_ = 0;
  bool automatic_ = true;
  float least_ = 0.0f, most_ = 1.0f;
  float zoom_ = 0.0f;         // pixels a texel; 0: the whole layer
  vec2 middle_ = vec2(0.5f);  // of the pane, as a share of the map
  uvec2 texel_ = uvec2(0);    // under the pointer
  bool shown_ = false;        // in the interface of this frame
  bool probed_ = false;
  MapPaneArguments arguments_ = {};  // of what this frame draws
  std::vector<ResourceUse> uses_;
};

}  // namespace gnomon::viewer
