// The loop: input, panels, frame, window.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/viewer/camera/camera_rig.h"
#include "app/viewer/measure/measure_panel.h"
#include "app/viewer/panels/scene_panel.h"
#include "app/viewer/panels/state_panels.h"
#include "app/viewer/state/opening.h"
#include "app/viewer/state/workspace.h"
#include "app/viewer/status_file.h"
#include "app/viewer/window/pace.h"
#include "app/viewer/window/render_scale.h"
#include "app/viewer/window/screen.h"

namespace gnomon::viewer {

struct ViewerOptions {
  uint32_t frames = 0;  // ends after so many, of all scenes; 0: when the user closes the window
  std::filesystem::path
      screenshot;  // the last frame with the interface: at rest, and with a complete reference where one is wanted
};

// A scene that has been opened, and what it is shown with.
struct Opened {
  // Kinds of light that the techniques do not serve get usual ones where the scene is `another` one than they were chosen for;
  // else that is an error. Throws what building says of scene and techniques.
  Opened(Opening& opening, Screen& screen, bool another);

  std::unique_ptr<Session> session;
  ViewState state;
  TechniqueSet techniques;
  std::vector<std::string> warnings;
};

// Waits for the first scene behind a window that already answers; nullopt: it was closed meanwhile. Throws what loading threw.
std::optional<Opened> open_first(Screen& screen, ViewState state);

// One scene, from its first frame until another one is opened or the window is closed.
class Viewer {
 public:
  Viewer(Screen& screen, Opened opened, Workspace& workspace, const ViewerOptions& options);
  // The scene that the user opened next; nullopt: the window is closed. Throws Interrupted.
  std::optional<Opened> run();

 private:
  void draw();
  void show_interface(ViewState& next);
  void record();
  void choose_draws();
  bool draws_small_maps() const { return pace_.last() == Pace::Draws::small_maps; }
  void record_picture(Recorder& recorder);
  void draw_once();
  Recorder& patient();
  void give_up();
  void follow_pace(float work_ms, bool size_is_free);
  void hand_out();
  void draw_second();
  bool is_drawn_as_it_stays() const { return !stays_finer_ || pace_.stays(); }
  float rest_scale() const;
  std::string& failure();  // that is shown now, of whoever failed first; empty: none
  PictureContent picture_content() const;
  void handle_keys();
  void move_camera(ViewState& state, float seconds);
  void follow(const ViewState& next);
  std::optional<Settings> parsed(const ViewState& state);  // nullopt: the message says what is wrong
  bool builds(const ViewState& next, const Settings& settings) const;
  void apply(const ViewState& wanted, const Settings& settings);
  void update_techniques(const std::vector<std::string>& names);  // and those with smaller maps where the view is slow
  uvec2 wanted_size() const;
  std::string command() const;          // `gnomon render ...` of the picture, without its output
  bool follow_size();                   // whether the picture has another size
  bool open(const std::string& scene);  // whether it is on its way; else the message says why not
  void follow_drops();
  void rebuild();

  Screen& screen_;
  Window& window_;
  Device& device_;
  Workspace& workspace_;
  Wishes& wishes_;
  ShaderReload& shaders_;
  Outputs& outputs_;
  ViewerOptions options_;
  ViewState state_;
  std::unique_ptr<Session> session_;
  TechniqueSet techniques_;
  TechniqueSet small_;  // the same with smaller maps, where the view is slow
  Pace pace_;
  bool may_shrink_ = false, was_slow_ = false;
  bool stays_finer_ = false;        // the picture at rest is, or will be, another one than while it moves
  uint32_t small_divisor_ = 0;      // of small_; 0: there is none
  std::optional<ViewState> drawn_;  // in the last frame
  std::string drawn_over_key_;      // what lay over it
  SharedReference rays_;
  Interface& interface_;
  StatusFile status_;
  Panels panels_;
  Explain explain_;
  StatePanels state_panels_;
  CameraRig camera_;
  Timings timings_;
  MeasurePanel measure_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<Recorder> patient_;  // of the picture that stays
  bool recorder_separates_ = false;
  std::string message_;
  Sides sides_;
  // To be shown behind the next frame: building it takes a while, and that frame says so.
  std::optional<ViewState> building_;
  std::optional<Opening> opening_;
  std::optional<Opened> next_;
  ScenePanel scene_panel_;
  RenderScale render_scale_;
  uvec2 last_window_ = uvec2(0), sized_for_ = uvec2(0);  // windows: of the last frame, of the picture's size
  std::optional<uvec2> refused_size_;                    // there was no memory for it
  std::chrono::steady_clock::time_point window_changed_;
  std::chrono::steady_clock::time_point last_frame_;
};

}  // namespace gnomon::viewer
