// Presets: the built-in ones, files, the clipboard.
#pragma once

#include "app/viewer/view_state.h"

namespace gnomon::viewer {

class PresetPanel {
 public:
  // `lights`: those that are shown. Throws Error where a preset cannot be read, used or written.
  void show(ViewState& state, uvec2 size, std::span<const Light> lights);

 private:
  void load(ViewState& state, const std::string& name, std::span<const Light> lights);
  void builtin_ones(ViewState& state, std::span<const Light> lights);
  void save(const ViewState& state, uvec2 size);

  bool keep_view_ = false;
  char file_[256] = "preset.json";
  std::string asks_;  // the file that exists: may it be replaced?
  std::string done_;
};

}  // namespace gnomon::viewer
