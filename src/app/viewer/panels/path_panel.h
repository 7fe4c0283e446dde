// Paths of cameras and suns: playing and recording them.
#pragma once

#include "app/viewer/camera/camera_rig.h"
#include "app/viewer/camera/path_player.h"
#include "app/viewer/camera/path_recorder.h"
#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

class PathPanel {
 public:
  // `own`: what is recorded or loaded is added there.
  explicit PathPanel(std::vector<Recording>& own) : own_(own) {}

  // Moves camera and sun of the state as time passes. True when it placed the camera.
  bool advance(ViewState& state, const Session& session, const CameraRig& rig, double seconds);
  // Throws Error where a file cannot be read or written.
  void show(const ViewState& state, const Session& session, const CameraRig& rig);
  // The user walks: the camera is no longer the path's.
  void stop_camera() { camera_.playing = false; }

 private:
  std::vector<CameraPath> camera_paths(const Session& session) const;
  std::vector<SunMotion> sun_paths(const Session& session) const;
  void move_sun(ViewState& state, const Session& session);
  void record(const ViewState& state, const Session& session, const CameraRig& rig);
  void files();
  void take(Recording recording);  // into the lists, chosen

  Playhead camera_, sun_;
  bool camera_scrubbed_ = false, sun_scrubbed_ = false;
  size_t camera_path_ = 0, sun_path_ = 0;  // of the scene's, then of own ones
  std::vector<Recording>& own_;            // recorded or loaded
  PathRecorder recorder_;
  char file_[256] = "walk.json";
  std::string done_;  // what was written or read last
};

}  // namespace gnomon::viewer
