// The window at the right: undo, camera, lights, paths, presets; and what of them is drawn over the picture.
#pragma once

#include "app/viewer/lights/light_panel.h"
#include "app/viewer/panels/camera_panel.h"
#include "app/viewer/panels/path_panel.h"
#include "app/viewer/panels/preset_panel.h"
#include "app/viewer/state/scene_work.h"
#include "app/viewer/state/undo_history.h"

namespace gnomon::viewer {

class StatePanels {
 public:
  // `work` outlives the scene.
  StatePanels(const ViewState& first, SceneWork& work) : history_(first), cameras_(work.cameras), paths_(work.paths) {}

  // Before the user's own steps: `moved` is true when those of this frame move the camera. Changes `state` by keys, clicks and
  // time. `message` gets what was not possible.
  void before_panels(ViewState& state, CameraRig& rig, Session& session, const Window& window, double seconds,
                     std::string& message);
  void show(ViewState& state, CameraRig& rig, Session& session, std::string& message);
  // The user moves the camera: a path no longer does.
  void user_moves_camera() { paths_.stop_camera(); }
  // Whether the left button is taken: by a handle, not by a panel.
  bool has_mouse() const { return lights_.has_mouse(); }

  // Undo and redo, where they were asked for in this frame: the state to show instead. Its picture has the size of `state`'s.
  std::optional<ViewState> travel(const ViewState& state);
  // The state as shown, in each frame.
  void remember(const ViewState& state) { history_.add(state); }

  // The rig stands where the session's camera is, after something else placed that.
  void follow_camera(CameraRig& rig, const Session& session);

 private:
  UndoHistory history_;
  CameraPanel cameras_;
  LightPanel lights_;
  PathPanel paths_;
  PresetPanel presets_;
  bool wants_undo_ = false, wants_redo_ = false, camera_placed_ = false;
  double now_s_ = 0.0;
};

}  // namespace gnomon::viewer
