// The measuring protocol: warm-up dropped, medians over frames, passes apart (docs/measuring.md).
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "base/statistics.h"
#include "gpu/recorder.h"

namespace gnomon {

constexpr int k_min_frames = 3;  // however long they take

struct TimingOptions {
  TimingMode mode = TimingMode::measure;
  int frames = 50, warm_up = 5;
  double max_seconds = 4.0;
};

// From the settings `measure`.
class Settings;
TimingOptions timing_options(const Settings& settings);

struct PassTiming {
  std::string name;
  PassStage stage;
  Summary ms;
  uint32_t draws = 0, dispatches = 0;
  uint64_t triangles = 0;
};

struct Timing {
  std::string mode, clock;
  int frames = 0, warm_up = 0;
  std::vector<PassTiming> passes;
  Summary frame_ms;   // the whole frame, measured by itself
  Summary record_ms;  // CPU: recording and submitting
  double sum_of_passes_ms() const;
  double stage_ms(PassStage stage) const;
};

// What is timed: frames that say themselves what they took.
class TimedFrames {
 public:
  virtual ~TimedFrames() = default;
  // apart: each pass in a submission of its own.
  virtual FrameResult draw(bool apart) = 0;
};

// Times the frame that `record` records. On a software device passes are submitted alone and timed by the wall clock, because
// its timestamps lie; whole frames alternate with those, in one submission. One frame at a time, so that several timers can
// take turns.
class FrameTimer {
 public:
  FrameTimer(Device& device, const TimingOptions& options, std::function<void(Recorder&)> record);
  // wall: by the wall clock, passes apart.
  FrameTimer(std::unique_ptr<TimedFrames> frames, const TimingOptions& options, bool wall);
  ~FrameTimer();
  FrameTimer(const FrameTimer&) = delete;
  FrameTimer& operator=(const FrameTimer&) = delete;

  void warm_up();  // a frame that is not counted
  void frame();
  Timing timing() const;  // after one frame at least

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Warm-up and frames as the options say.
Timing time_frames(Device& device, const TimingOptions& options, const std::function<void(Recorder&)>& record);
// By a clock in seconds, against which max_seconds counts: from the end of the warm-up.
Timing time_frames(FrameTimer& timer, const TimingOptions& options, const std::function<double()>& now_s);

nlohmann::json passes_to_json(const Timing& timing);
nlohmann::json timing_to_json(const Timing& timing);

}  // namespace gnomon
