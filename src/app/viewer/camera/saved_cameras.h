// Cameras that the user keeps, by number; and those that the scene brings.
#pragma once

#include <map>

#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

class SavedCameras {
 public:
  // Place and lens as the state has them. Numbers are 1 to 9, those of the keys.
  void store(int number, const ViewState& state);
  // False where there is none of that number.
  bool recall(int number, ViewState& state) const;
  void remove(int number) { cameras_.erase(number); }
  std::vector<int> numbers() const;
  int free_number() const;  // 9 where all are taken

 private:
  struct Saved {
    std::string camera;
    std::map<std::string, std::string> lens;  // edits of camera.*
  };
  std::map<int, Saved> cameras_;
};

// Shows a camera of the scene with its own lens; `camera` as --camera reads it.
void choose_scene_camera(ViewState& state, const std::string& camera);
// A camera given as text has the lens of the settings: that of the session's camera goes with it. Call it where the state's
// camera becomes text.
void keep_lens(ViewState& state, const Session& session);

}  // namespace gnomon::viewer
