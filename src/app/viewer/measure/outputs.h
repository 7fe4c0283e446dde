// What leaves the window: pictures, clips, a report of collected settings.
#pragma once

#include <string>

#include "app/viewer/compare/comparison.h"
#include "app/viewer/measure/clip.h"
#include "app/viewer/notice.h"
#include "app/viewer/window/background.h"

namespace gnomon::viewer {

class Outputs {
 public:
  explicit Outputs(Device& device);

  // A panel. `next`: what "add" collects and the report shows.
  void show(const ViewState& next, const Session& session);
  // Of the picture without interface, in its own size: ".png" (display values) or ".exr" (scene-linear). In force after the
  // frame.
  void want_picture(const std::string& extension) { wanted_ = extension; }
  // After each frame: takes it where a picture or a clip wants it. A picture that is written is told in `notices`, with its
  // `content`.
  void take(const ViewState& state, Session& session, const PictureContent& content, Notices& notices);
  // Goes on with a report, and learns what could not be written; also while the window is minimised.
  void update();

  // A report is being measured: the window should leave the device alone.
  bool measuring() const { return comparison_.busy(); }
  // What the coming frame is wanted for.
  bool wants_picture() const { return !wanted_.empty(); }
  bool wants_frame() const { return wants_picture() || clip_.running(); }
  // A clip has begun: its pictures must be of one size.
  bool recording() const { return clip_.running() && clip_.count() > 0; }
  void stop_clip() { clip_.stop(); }
  // What failed, until it is closed.
  std::string& message() { return message_; }

 private:
  void picture(const ViewState& state, Session& session, PictureContent content, Notices& notices);
  void show_clip();
  void show_comparison(const ViewState& next, const Session& session);
  void show_progress();

  Background background_;
  Clip clip_;
  Comparison comparison_;
  std::string wanted_, message_;
  char clip_name_[128] = "gnomon_clip", report_name_[128] = "gnomon_report";
  float clip_seconds_ = 5.0f;
};

}  // namespace gnomon::viewer
