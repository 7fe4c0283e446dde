// Two sides of one view: settings beside other settings or the reference, the error of what is shown, and its scores.
#pragma once

#include <array>
#include <memory>

#include "app/viewer/compare/view_reference.h"
#include "app/viewer/explain/explain.h"
#include "app/viewer/state/technique_set.h"
#include "app/viewer/state/view_state.h"
#include "app/viewer/window/canvas.h"
#include "measure/visibility_error.h"

namespace gnomon::viewer {

enum class SecondSide { none, settings, reference };

// What the user has chosen to compare.
struct SidesChoice {
  SecondSide second = SecondSide::none;
  ViewState other;  // of SecondSide::settings; camera and lights are those of the first side
  bool flip_mode = false, flipped = false;
  float divider = 0.5f;
  bool error = false, scores = false;  // error: over the picture
};

class Sides {
 public:
  // `choice` outlives the scene: where it was made in another one, what belongs to that scene is left behind. Keeps a reference
  // to `rays`.
  Sides(SidesChoice& choice, const ViewState& state, SharedReference& rays);

  // `light`: whose error is shown. Exchanging the sides changes `state`.
  void show(ViewState& state, const Session& session, size_t light);
  void show_divider();  // and the names of the sides, over the picture

  // The second side's picture with what `explain` says of it, where it is out of date; the session then shows `state` again,
  // and true means that the frame holds the other side's surface and masks. Throws Error where the second side's settings
  // cannot be shown: there is then no second side; GivenUp where `recorder` does.
  bool draw_second(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas, Explain& explain);
  // Behind the first side's shading.
  void record_error(Recorder& recorder, const Frame& frame) const;
  // Behind each frame: traces on, and computes the scores of what the frame's mask holds now. Throws Error.
  void follow(Session& session);

  // Share of the window's width that belongs to the first side.
  float divider() const;
  // The other picture, whole; from a split picture the second one.
  void flip() {
    if (choice_.second != SecondSide::none) choice_.flipped = !choice_.flip_mode || !choice_.flipped, choice_.flip_mode = true;
  }
  void toggle_error() { choice_.error = !choice_.error; }
  // What lies over the first side's picture changes with this.
  std::string key() const;
  // Whether the second side's picture also depends on those before it.
  bool has_history() const { return second_settings() && techniques_.has_history(); }
  bool shows_error() const { return choice_.error && reference_ && reference_->answer(); }
  // The session's frame is made again: nothing of the old one may be held.
  void forget() { techniques_.clear(), second_key_.clear(), score_ = {}, reference_.reset(); }
  bool second_settings() const { return choice_.second == SecondSide::settings; }
  bool compares() const { return choice_.second != SecondSide::none || choice_.error; }
  bool has_reference() const { return wants_reference() && reference_ && reference_->under_way(); }
  bool wants_reference() const { return choice_.second == SecondSide::reference || choice_.error || choice_.scores; }
  bool waits_for_reference() const { return wants_reference() && !(reference_ && reference_->complete()); }

 private:
  struct Score {
    VisibilityError error;
    int samples = 0;  // of the reference that it was compared with
  };

  ViewState second_state(const ViewState& first) const;
  bool draw_settings(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas, Explain& explain);
  void draw_reference(Recorder& recorder, Session& session, Canvas& canvas);
  std::optional<Score> score(Session& session) const;
  void show_reference() const;
  void show_scores() const;

  SharedReference& rays_;
  SidesChoice& choice_;
  TechniqueSet techniques_;             // of choice_.other
  ViewState first_, made_of_, second_;  // of SecondSide::settings: the state that is shown, and the two that it was made of
  std::vector<std::byte> second_key_;   // of what the second picture shows
  int settling_ = 0;                    // frames that the second picture still needs
  size_t light_ = 0;
  std::unique_ptr<ViewReference> reference_;  // from its first use on
  std::array<std::optional<Score>, 2> score_;
  std::array<std::string, 2> names_;
  std::chrono::steady_clock::time_point scored_;
};

}  // namespace gnomon::viewer
