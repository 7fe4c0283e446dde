// A scene on its way: a thread of its own loads it, while the window goes on.
#pragma once

#include <chrono>
#include <future>

#include "app/viewer/state/view_state.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/warning_watch.h"

namespace gnomon::viewer {

class Opening {
 public:
  explicit Opening(ViewState state);
  // Gives the scene up where it is not there yet.
  ~Opening() { cancellation_.cancel(); }
  Opening(const Opening&) = delete;
  Opening& operator=(const Opening&) = delete;

  const std::string& scene_name() const { return state_.view.scene; }
  std::string status() const;                            // what is being done, and for how long
  double share() const { return watch_.state().share; }  // of that

  bool ready() const;
  // Once it is ready. Throws what loading threw.
  std::unique_ptr<Session> finish(Device& device, uvec2 size);
  ViewState state() const { return state_; }
  // Once it is ready: what the same scene is to be shown with instead.
  void set_state(ViewState state) { state_ = std::move(state); }
  // Of loading and of what came since.
  std::vector<std::string> warnings() const { return warnings_.texts(); }

 private:
  ViewState state_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ProgressWatch watch_;
  WarningWatch warnings_;
  Cancellation cancellation_;
  std::future<Scene> scene_;  // last: its thread uses the others
};

}  // namespace gnomon::viewer
