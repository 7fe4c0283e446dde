// The measuring protocol: warm-up dropped, medians over frames, passes apart (docs/measuring.md).
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "base/statistics.h"
#include "gpu/recorder.h"

namespace gnomon {

struct TimingOptions {
  TimingMode mode = TimingMode::measure;
  int frames = 50, warm_up = 5;
  double max_seconds = 4.0;
};

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

// Times the frame that `record` records. On a software device passes are submitted alone and timed by the wall clock, because
// its timestamps lie; whole frames alternate with those, in one submission.
Timing time_frames(Device& device, const TimingOptions& options, const std::function<void(Recorder&)>& record);

nlohmann::json passes_to_json(const Timing& timing);
nlohmann::json timing_to_json(const Timing& timing);

}  // namespace gnomon
