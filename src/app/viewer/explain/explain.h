// "Explain": overlays, the light's views as lines, the map, and everything about a picked pixel.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "app/viewer/explain/map_pane.h"
#include "app/viewer/explain/pick_window.h"
#include "app/viewer/state/technique_set.h"
#include "app/viewer/window/window.h"
#include "shadow/explainer.h"

namespace gnomon::viewer {

// What the user has chosen to see.
struct ExplainOptions {
  uint32_t overlay = k_overlay_none;
  float opacity = 0.6f;  // of the overlay
  bool lines = false;    // of the light's views
  bool map_open = false;
  uint32_t map_layer = 0;
  bool map_layer_given = false;  // it must exist, or else the next frame fails
  std::optional<uvec2> pick;     // pixel of the picture, to be picked in the next frame
};

// Reads --overlay ("layers", "layers,lines"), --pick ("120,80") and --map ("0"); empty: not given. Throws Error (usage), naming
// what is valid.
ExplainOptions parse_explain_options(const std::string& overlay, const std::string& pick, const std::string& map);

class Explain {
 public:
  // `render_pass`: that the interface is drawn in. `options` outlive the scene; keeps a reference to `rays`.
  Explain(Device& device, VkRenderPass render_pass, ExplainOptions& options, SharedReference& rays);

  // Pipelines of the shaders as they are now.
  void rebuild(VkRenderPass render_pass);

  // Once a frame, whether panels are shown or not.
  void handle_keys(const Window& window);
  // Panel and windows, while the interface's frame is written.
  void show(Session& session, const TechniqueSet& techniques);
  // Crosshair and lines, which stay when the panels are hidden.
  void show_marks(Session& session);
  // Before a frame is recorded. `divider`: share of the window's width that shows the first side; `explained`: whether a
  // technique draws the rest, which is then explained, too.
  void set_sides(float divider, bool explained) { divider_ = divider, second_is_explained_ = explained; }
  // Behind Session::record_frame of side 0 or 1: overlays on both, a pick on the side that shows it, lines and map of the
  // first.
  void record(Recorder& recorder, Session& session, const TechniqueSet& techniques, size_t side);
  // Once the recorder has finished, while the session still shows that side.
  void collect(Session& session, const TechniqueSet& techniques, size_t side);
  // What is said of the pick, in each frame: the reference's answer may come later.
  void judge(Session& session);
  // A side's picture is out of date where this changes.
  std::string key(size_t side) const;
  // Nothing of the shared rays is used behind this, until the next pick is judged.
  void forget_rays() { reference_.reset(); }
  bool reads_map() const { return options_.map_open; }  // in each frame
  bool reads_frame() const { return place_ || options_.map_open || options_.lines || options_.overlay != k_overlay_none; }
  // What the overlay is called; empty where none lies over the picture.
  std::string overlay_drawn() const;
  // What the pass that draws the interface must name.
  std::span<const ResourceUse> uses() const { return map_pane_.uses(); }

 private:
  struct Held {
    std::vector<ShadowView> views;
    CameraData camera;
  };

  void handle_pick(Session& session);
  void check_map_layer(const TechniqueSpec& spec, const std::optional<ShadowMapView>& map);
  void panel(Session& session, const TechniqueSet& techniques);
  uvec2 pixel(const Session& session) const;
  PickedSide picked_side() const;
  bool picks_on(size_t side) const { return place_ && (picked_side() == PickedSide::second) == (side == 1); }

  SharedReference& rays_;
  Explainer explainer_;
  MapPane map_pane_;
  ExplainOptions& options_;
  bool overlay_drawn_ = false;
  size_t light_ = 0;
  float divider_ = 1.0f;
  bool second_is_explained_ = false;
  bool pick_mode_ = false;
  std::optional<vec2> place_;  // picked, as a share of the picture: it stays where it is when the picture's size changes
  std::optional<Picked> picked_;
  std::array<std::vector<ShadowView>, 2> views_;  // of each side's last frame
  std::optional<Held> held_;                      // lines that stay while the camera leaves
  std::unique_ptr<PointReference> reference_;
};

}  // namespace gnomon::viewer
