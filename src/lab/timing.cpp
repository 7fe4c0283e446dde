// The measuring protocol.
#include "lab/timing.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/interrupt.h"

namespace gnomon {
namespace {

constexpr int k_min_frames = 3;

struct Series {
  std::vector<std::vector<double>> passes;
  std::vector<double> frame, record;
};

void add_passes(Series& series, const FrameResult& frame, bool wall) {
  series.passes.resize(frame.passes.size());
  for (size_t i = 0; i < frame.passes.size(); ++i) series.passes[i].push_back(wall ? frame.passes[i].wall_ms : frame.passes[i].gpu_ms);
}

}  // namespace

Timing time_frames(Device& device, const TimingOptions& options, const std::function<void(Recorder&)>& record) {
  const bool software = device.info().software;
  const bool wall = software || device.info().timestamp_ms == 0.0;
  Recorder whole(device, options.mode, false), apart(device, options.mode, true);
  const auto draw = [&](Recorder& recorder) {
    check_interrupted();
    recorder.begin();
    record(recorder);
    return recorder.finish();
  };
  for (int i = 0; i < options.warm_up; ++i) draw(whole);

  Series series;
  FrameResult last;
  const auto start = std::chrono::steady_clock::now();
  int frames = 0;
  for (; frames < options.frames; ++frames) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (frames >= k_min_frames && elapsed.count() > options.max_seconds) break;
    last = draw(whole);
    series.record.push_back(last.record_ms);
    const double frame_ms = wall ? last.wall_ms : last.gpu_ms;
    if (wall) last = draw(apart);
    series.frame.push_back(std::max(frame_ms - last.submission_ms, 0.0));
    add_passes(series, last, wall);
  }

  Timing timing;
  timing.mode = options.mode == TimingMode::measure ? "measure" : "play";
  timing.clock = wall ? "wall clock, each pass submitted alone" : "gpu timestamps";
  timing.frames = frames;
  timing.warm_up = options.warm_up;
  timing.frame_ms = summarise(series.frame);
  timing.record_ms = summarise(series.record);
  for (size_t i = 0; i < last.passes.size(); ++i) {
    const PassResult& pass = last.passes[i];
    timing.passes.push_back({pass.name, pass.stage, summarise(series.passes[i]), pass.draws, pass.dispatches, pass.triangles});
  }
  return timing;
}

double Timing::sum_of_passes_ms() const {
  double sum = 0.0;
  for (const auto& pass : passes) sum += pass.ms.median;
  return sum;
}

double Timing::stage_ms(PassStage stage) const {
  double sum = 0.0;
  for (const auto& pass : passes) sum += pass.stage == stage ? pass.ms.median : 0.0;
  return sum;
}

nlohmann::json passes_to_json(const Timing& timing) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& pass : timing.passes) {
    list.push_back({{"name", pass.name},
                    {"stage", stage_name(pass.stage)},
                    {"median_ms", pass.ms.median},
                    {"p95_ms", pass.ms.p95},
                    {"mad_ms", pass.ms.mad},
                    {"draws", pass.draws},
                    {"dispatches", pass.dispatches},
                    {"triangles", pass.triangles}});
  }
  return list;
}

nlohmann::json timing_to_json(const Timing& timing) {
  return {{"mode", timing.mode},
          {"clock", timing.clock},
          {"frames", timing.frames},
          {"warm_up", timing.warm_up},
          {"frame_ms", timing.frame_ms.median},
          {"record_ms", timing.record_ms.median},
          {"sum_of_passes_ms", timing.sum_of_passes_ms()}};
}

}  // namespace gnomon
