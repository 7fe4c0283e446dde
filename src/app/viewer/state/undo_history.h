// What the window showed before: one step for each thing that the user did.
#pragma once

#include <vector>

#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

class UndoHistory {
 public:
  explicit UndoHistory(ViewState first, size_t limit = 200) : states_{std::move(first)}, limit_(limit) {}

  // Once a frame, before `add`. A gesture lasts as long as `held`: a mouse button that is down. All that it changes of one
  // thing (a slider, a light, the camera) is one step. A walk is one step too, although the keys are let go and pressed again
  // on the way.
  void tick(double now_s, bool held);
  // The state that is now shown. What a redo could have brought back is forgotten.
  void add(const ViewState& state);

  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  // The state before, or after: it is the current one from now on.
  const ViewState& undo();
  const ViewState& redo();

 private:
  std::vector<ViewState> states_;  // the oldest first; never empty
  size_t at_ = 0;                  // of the current one
  size_t limit_;
  // Of the last step, as long as more may be added to it.
  std::vector<std::string> parts_;
  bool open_ = false;
  double changed_s_ = 0.0, now_s_ = 0.0;
  int frames_since_ = 0;
};

// What differs, by name: "camera", "lights", "techniques", "samples", keys of edits ("pcf.size").
std::vector<std::string> different_parts(const ViewState& a, const ViewState& b);

}  // namespace gnomon::viewer
