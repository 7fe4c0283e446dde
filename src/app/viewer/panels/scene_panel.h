// Which scene is shown: built-in ones, recent files, a path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/viewer/state/recent_files.h"
#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

class ScenePanel {
 public:
  // The scene that the user asked for in this frame.
  std::optional<std::string> show(const std::string& shown_scene, const RecentFiles& recent);
  // A list of objects and materials that switches their shadows.
  void show_casting(ViewState& state, const Scene& scene);

 private:
  struct Row {
    std::string name;
    const Object* object = nullptr;  // the first of that name; or
    const Material* material = nullptr;
  };
  void find_rows(const Scene& scene);

  char path_[1024] = {}, filter_[256] = {};
  std::vector<Row> rows_;  // that pass the filter
  const Scene* rows_of_ = nullptr;
};

// A box with a bar, and one without, while something takes its time.
void show_notice(const std::string& text);
void show_progress(const std::string& text, double share);

}  // namespace gnomon::viewer
