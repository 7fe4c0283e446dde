#include "app/viewer/path_recorder.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

constexpr double k_key_distance_s = 0.1;

bool same(const CameraKey& key, const CameraPose& pose) { return key.eye == pose.eye && key.target == pose.target; }

}  // namespace

void PathRecorder::start(const CameraPose& pose) {
  keys_ = {{0.0, pose.eye, pose.target}};
  last_ = pose;
  time_s_ = 0.0;
  records_ = true;
}

void PathRecorder::add(double seconds, const CameraPose& pose) {
  GNOMON_ASSERT(records_);
  time_s_ += seconds;
  last_ = pose;
  if (time_s_ - keys_.back().time_s >= k_key_distance_s) keys_.push_back({time_s_, pose.eye, pose.target});
}

std::optional<CameraPath> PathRecorder::stop(const std::string& name) {
  records_ = false;
  if (time_s_ > keys_.back().time_s) keys_.push_back({time_s_, last_.eye, last_.target});
  // The pauses before the first step and after the last one are no part of the walk.
  while (keys_.size() > 1 && same(keys_[keys_.size() - 2], {keys_.back().eye, keys_.back().target})) keys_.pop_back();
  while (keys_.size() > 1 && same(keys_[1], {keys_[0].eye, keys_[0].target})) keys_.erase(keys_.begin());
  if (keys_.size() < 2) return std::nullopt;
  const double begin_s = keys_.front().time_s;
  for (CameraKey& key : keys_) key.time_s -= begin_s;
  return CameraPath{name, std::move(keys_)};
}

}  // namespace gnomon::viewer
