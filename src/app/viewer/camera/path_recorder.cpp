#include "app/viewer/camera/path_recorder.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

constexpr double k_key_distance_s = 0.1;

bool same(const CameraPose& a, const CameraPose& b) { return a.eye == b.eye && a.target == b.target; }
bool same(const SunState& a, const SunState& b) {
  return a.direction == b.direction && a.colour == b.colour && a.intensity == b.intensity;
}
bool same(const Moment& a, const Moment& b) {
  const bool suns = a.sun && b.sun ? same(*a.sun, *b.sun) : a.sun.has_value() == b.sun.has_value();
  return same(a.camera, b.camera) && suns;
}

// Between two suns that are opposite each other there is no shortest way (lab/view/path_file refuses such keys): it leads past
// the zenith.
bool opposite(const SunState& a, const SunState& b) { return glm::dot(a.direction, b.direction) < -0.99f; }
SunState between(const SunState& a, const SunState& b) {
  const vec3 down(0.0f, -1.0f, 0.0f);
  const vec3 across = down - glm::dot(down, a.direction) * a.direction;
  SunState sun = b;
  sun.direction = glm::length(across) > 0.01f ? glm::normalize(across) : vec3(1.0f, 0.0f, 0.0f);
  return sun;
}

}  // namespace

void PathRecorder::start(const Moment& moment) {
  keys_ = {{0.0, moment}};
  last_ = moment;
  time_s_ = 0.0;
  records_ = true;
}

void PathRecorder::add(double seconds, const Moment& moment) {
  GNOMON_ASSERT(records_);
  time_s_ += seconds;
  const auto sun = moment.sun ? moment.sun : last_.sun;
  // One that came later has stood there from the begin.
  if (sun && !last_.sun) std::for_each(keys_.begin(), keys_.end(), [&](Key& key) { key.moment.sun = sun; });
  last_ = {moment.camera, sun};
  if (time_s_ - keys_.back().time_s >= k_key_distance_s) keys_.push_back({time_s_, last_});
}

std::optional<Recording> PathRecorder::stop(const std::string& name) {
  records_ = false;
  if (time_s_ > keys_.back().time_s) keys_.push_back({time_s_, last_});
  // The pauses before the first step and after the last one are no part of it.
  while (keys_.size() > 1 && same(keys_[keys_.size() - 2].moment, keys_.back().moment)) keys_.pop_back();
  while (keys_.size() > 1 && same(keys_[1].moment, keys_[0].moment)) keys_.erase(keys_.begin());
  if (keys_.size() < 2) return std::nullopt;
  CameraPath camera{name, {}};
  RecordedSun sun{name, {}};
  bool camera_moves = false, sun_moves = false;
  const Key first = keys_.front();
  for (const Key& key : keys_) {
    const double time_s = key.time_s - first.time_s;
    camera.keys.push_back({time_s, key.moment.camera.eye, key.moment.camera.target});
    camera_moves = camera_moves || !same(key.moment.camera, first.moment.camera);
    if (!key.moment.sun) continue;
    if (!sun.keys.empty() && opposite(sun.keys.back().state, *key.moment.sun)) {
      const SunKey& last = sun.keys.back();
      sun.keys.push_back({0.5 * (last.time_s + time_s), between(last.state, *key.moment.sun)});
    }
    sun.keys.push_back({time_s, *key.moment.sun});
    sun_moves = sun_moves || !same(*key.moment.sun, *first.moment.sun);
  }
  Recording recording;
  if (camera_moves) recording.camera = std::move(camera);
  if (sun_moves) recording.sun = std::move(sun);
  return recording;
}

}  // namespace gnomon::viewer
