// Presets: the built-in ones, files, the clipboard.
#pragma once

#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

class PresetPanel {
 public:
  // Throws Error where a preset cannot be read, used or written.
  void show(ViewState& state, const Session& session);

 private:
  void load(ViewState& state, const std::string& name, const Scene& scene);
  void builtin_ones(ViewState& state, const Scene& scene);
  void save(const ViewState& state, uvec2 size);

  bool keep_view_ = false;
  char file_[256] = "preset.json";
  std::string asks_;  // the file that exists: may it be replaced?
  std::string done_;
};

}  // namespace gnomon::viewer
