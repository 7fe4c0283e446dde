// Two sides of one view: settings beside other settings or the reference, the error of what is shown, and its scores.
#pragma once

#include <array>
#include <memory>

#include "app/viewer/canvas.h"
#include "app/viewer/technique_set.h"
#include "app/viewer/view_reference.h"
#include "app/viewer/view_state.h"
#include "measure/visibility_error.h"

namespace gnomon::viewer {

enum class SecondSide { none, settings, reference };

class Sides {
 public:
  // How it starts.
  struct Start {
    SecondSide second = SecondSide::none;
    std::string technique;  // of other settings; empty: as the first side
    bool error = false;     // error over the picture
  };
  // Keeps a reference to `rays`.
  Sides(const Start& start, const ViewState& state, SharedReference& rays);

  // `light`: whose error is shown. Exchanging the sides changes `state`.
  void show(ViewState& state, const Session& session, size_t light);
  void show_divider();  // and the names of the sides, over the picture

  // The second side's picture, where it is out of date; the session then shows `state` again. Throws Error where the second side's settings
  // cannot be shown: there is then no second side.
  void draw_second(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas);
  // Behind the first side's shading.
  void record_error(Recorder& recorder, const Frame& frame) const;
  // Behind each frame: traces on, and computes the scores of what the frame's mask holds now. Throws Error.
  void follow(Session& session);

  // Share of the window's width that belongs to the first side.
  float divider() const;
  // The other picture, whole; from a split picture the second one.
  void flip() {
    if (second_ != SecondSide::none) flipped_ = !flip_mode_ || !flipped_, flip_mode_ = true;
  }
  void toggle_error() { error_ = !error_; }
  bool shows_error() const { return error_ && reference_ && reference_->answer(); }
  // The session's frame is made again: nothing of the old one may be held.
  void forget() { techniques_.clear(), second_key_.clear(), score_ = {}, reference_.reset(); }
  bool second_settings() const { return second_ == SecondSide::settings; }
  bool wants_reference() const { return second_ == SecondSide::reference || error_ || scores_; }
  bool waits_for_reference() const { return wants_reference() && !(reference_ && reference_->complete()); }

 private:
  struct Score {
    VisibilityError error;
    int samples = 0;  // of the reference that it was compared with
  };

  ViewState second_state(const ViewState& first) const;
  void draw_settings(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas);
  void draw_reference(Recorder& recorder, Session& session, Canvas& canvas);
  std::optional<Score> score(Session& session) const;
  void show_reference() const;
  void show_scores() const;

  SharedReference& rays_;
  SecondSide second_;
  ViewState other_;           // of SecondSide::settings; camera and lights are those of the first side
  TechniqueSet techniques_;   // of other_
  std::vector<std::byte> second_key_;  // of what the second picture shows
  int settling_ = 0;          // frames that the second picture still needs
  bool flip_mode_ = false, flipped_ = false;
  float divider_ = 0.5f;
  bool error_, scores_ = false;
  size_t light_ = 0;
  std::unique_ptr<ViewReference> reference_;  // from its first use on
  std::array<std::optional<Score>, 2> score_;
  std::array<std::string, 2> names_;
  std::chrono::steady_clock::time_point scored_;
};

}  // namespace gnomon::viewer
