// What the viewer shows, as a JSON file that is replaced after each frame: window tests and the script that makes the manual's
// pictures wait for it and click by it. Off unless the environment variable GNOMON_VIEW_STATUS names the file.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/maths.h"

namespace gnomon::viewer {

struct ViewStatus {
  uvec2 window_size, picture_size;  // pixels
  std::string command;              // `gnomon render ...` of the picture, without its output
  std::string camera;               // as --camera reads it
  std::string message;              // on screen; empty: none
  bool vsync = true;
  bool loading = false;   // a scene is being read; the former is still shown
  bool full_maps = true;  // the picture's maps are those in force (Pace)
};

class StatusFile {
 public:
  StatusFile();
  ~StatusFile();
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;

  bool on() const { return !path_.empty(); }
  // At the end of a frame: `status`, the number of the frame, and the widgets and texts noted since the last one.
  void write(const ViewStatus& status);

 private:
  friend void note_area(std::string_view name, std::string_view part, vec2 min_px, vec2 max_px);
  friend void note_text(std::string_view name, std::string_view text);

  std::filesystem::path path_;
  nlohmann::json widgets_ = nlohmann::json::object(), texts_ = nlohmann::json::object();
  uint64_t frame_ = 0;
};

// Behind a widget: its rectangle goes to the status file, if there is one and if the widget's middle can be clicked. `part`
// names one of several that belong together: "single.fit:scene".
void note_widget(std::string_view name, std::string_view part = {});
// Between ImGui's Begin and End: the whole window's rectangle.
void note_window(std::string_view name);
// A handle that is drawn over the picture.
void note_point(std::string_view name, vec2 at_px);
// What a part of the interface says, for "texts" of the file.
void note_text(std::string_view name, std::string_view text);

}  // namespace gnomon::viewer
