// The panels: what they show comes from the catalogue of techniques and the parameter tables.
#pragma once

#include "app/viewer/panels/param_editor.h"
#include "app/viewer/state/technique_set.h"
#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

// What the user wants of the program, beside another picture.
struct Wishes {
  bool interface = true;
  bool vsync = true;
  bool separate_passes = false;
  float scale = 1.0f;       // size of the picture, relative to the window's
  bool adapt_size = true;   // `scale` follows the time that a frame takes
  float target_ms = 40.0f;  // of a frame
  // Of this frame only:
  bool screenshot = false, copy_command = false;
};

enum class MessageKind { failure, notice };

// The window on the left. What several classes show between this and ImGui::End stands in it one below the other.
bool begin_main_panel();

class Panels {
 public:
  explicit Panels(const Settings& start) : start_(start) {}

  // Changes `state` and `wishes` as the user wants them; the session still shows the old state.
  void show(ViewState& state, Wishes& wishes, Session& session, const TechniqueSet& techniques);
  // A box over the picture, where there is a text. True when the user closes it.
  static bool show_message(const std::string& text, MessageKind kind);
  size_t light() const { return light_; }  // whose technique is shown
  void set_speed(float speed_m_s) { speed_m_s_ = speed_m_s; }
  void set_map_divisor(uint32_t divisor) { map_divisor_ = divisor; }  // of maps while the view moves

 private:
  void technique(ViewState& state, Session& session, const TechniqueSet& techniques);
  void technique_params(ViewState& state, Session& session, const TechniqueSpec& spec);
  void scene_params(ViewState& state, Session& session);
  static void samples(ViewState& state, const Session& session);
  void window(Wishes& wishes, const Session& session) const;

  Settings start_;  // with what the scene decided about light and camera
  ParamEditor editor_;
  size_t light_ = 0;  // whose technique is shown
  float speed_m_s_ = 0.0f;
  uint32_t map_divisor_ = 1;
};

}  // namespace gnomon::viewer
