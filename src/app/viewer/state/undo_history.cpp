#include "app/viewer/state/undo_history.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

// A walk goes on when the camera moves again within this time, or within as many frames: slow ones take longer.
constexpr double k_walk_gap_s = 0.6;
constexpr int k_walk_gap_frames = 2;

bool moves_camera_only(const std::vector<std::string>& parts) { return parts == std::vector<std::string>{"camera"}; }

}  // namespace

std::vector<std::string> different_parts(const ViewState& a, const ViewState& b) {
  std::vector<std::string> parts;
  const auto lens = [](const std::string& key) { return key.starts_with("camera."); };
  const auto value = [](const ViewState& state, const std::string& key) {
    const auto found = state.edits.find(key);
    return found == state.edits.end() ? std::string() : found->second;
  };
  // The first step of a walk also pins the lens of the camera that was left.
  if (a.view.camera != b.view.camera) parts.emplace_back("camera");
  if (a.view.lights != b.view.lights) parts.emplace_back("lights");
  if (a.view.casts != b.view.casts) parts.emplace_back("casts");
  if (a.view.samples != b.view.samples) parts.emplace_back("samples");
  if (a.techniques != b.techniques) parts.emplace_back("techniques");
  if (a.base.assignments() != b.base.assignments()) parts.emplace_back("settings");
  std::map<std::string, std::string> keys = a.edits;
  keys.insert(b.edits.begin(), b.edits.end());
  const bool moved = a.view.camera != b.view.camera;
  for (const auto& [key, unused] : keys) {
    if (value(a, key) != value(b, key) && !(moved && lens(key))) parts.push_back(key);
  }
  return parts;
}

void UndoHistory::tick(double now_s, bool held) {
  now_s_ = now_s;
  if (!held) open_ = false;
  ++frames_since_;
}

void UndoHistory::add(const ViewState& state) {
  std::vector<std::string> parts = different_parts(states_[at_], state);
  if (parts.empty()) return;
  const bool walks = moves_camera_only(parts) && (now_s_ - changed_s_ < k_walk_gap_s || frames_since_ <= k_walk_gap_frames);
  // The first light that a drag touches may bring its settings along: "lights" then is among several.
  const bool same = parts == parts_ || (parts.size() == 1 && std::find(parts_.begin(), parts_.end(), parts[0]) != parts_.end());
  const bool merges = at_ > 0 && !can_redo() && same && (open_ || walks);
  states_.resize(at_ + 1);
  if (merges) {
    states_[at_] = state;
  } else {
    states_.push_back(state);
    if (states_.size() > limit_ + 1) states_.erase(states_.begin());
    at_ = states_.size() - 1;
    parts_ = std::move(parts);
  }
  open_ = true;
  changed_s_ = now_s_;
  frames_since_ = 0;
}

const ViewState& UndoHistory::undo() {
  GNOMON_ASSERT(can_undo());
  parts_.clear();
  return states_[--at_];
}

const ViewState& UndoHistory::redo() {
  GNOMON_ASSERT(can_redo());
  parts_.clear();
  return states_[++at_];
}

}  // namespace gnomon::viewer
