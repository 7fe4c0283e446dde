// Cameras: orbit, those that the user keeps, those of the scene.
#pragma once

#include "app/viewer/camera/camera_rig.h"
#include "app/viewer/camera/saved_cameras.h"
#include "app/viewer/window/window.h"

namespace gnomon::viewer {

class CameraPanel {
 public:
  explicit CameraPanel(SavedCameras& saved) : saved_(saved) {}

  // True when another camera was chosen.
  bool show(ViewState& state, CameraRig& rig, Session& session);
  // O, 1 to 9, and with Control; a double-click on the picture.
  bool keys(ViewState& state, CameraRig& rig, Session& session, const Window& window);
  bool focus(CameraRig& rig, Session& session);
  // What is orbited, while it is.
  void show_centre(const CameraRig& rig, Session& session) const;

 private:
  SavedCameras& saved_;
};

}  // namespace gnomon::viewer
