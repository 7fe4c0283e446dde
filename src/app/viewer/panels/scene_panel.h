// Which scene is shown: built-in ones, recent files, a path.
#pragma once

#include <optional>
#include <string>

#include "app/viewer/state/recent_files.h"

namespace gnomon::viewer {

class ScenePanel {
 public:
  // The scene that the user asked for in this frame.
  std::optional<std::string> show(const std::string& shown_scene, const RecentFiles& recent);

 private:
  char path_[1024] = {};
};

// A box with a bar, and one without, while something takes its time.
void show_notice(const std::string& text);
void show_progress(const std::string& text, double share);

}  // namespace gnomon::viewer
