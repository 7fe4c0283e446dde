// The measuring protocol.
#include "lab/timing/timing.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/interrupt.h"
#include "lab/view/lab_params.h"
#include "lab/view/settings.h"

namespace gnomon {
namespace {

struct Series {
  std::vector<std::vector<double>> passes;
  std::vector<double> frame, record;
};

void add_passes(Series& series, const FrameResult& frame, bool wall) {
  series.passes.resize(frame.passes.size());
  for (size_t i = 0; i < frame.passes.size(); ++i)
    series.passes[i].push_back(wall ? frame.passes[i].wall_ms : frame.passes[i].gpu_ms);
}

FrameResult draw(Recorder& recorder, const std::function<void(Recorder&)>& record) {
  check_interrupted();
  recorder.begin();
  record(recorder);
  return recorder.finish();
}

}  // namespace

struct FrameTimer::State {
  State(Device& device, const TimingOptions& timing_options, std::function<void(Recorder&)> record_frame)
      : options(timing_options),
        wall(device.info().software || device.info().timestamp_ms == 0.0),
        whole(device, options.mode, false),
        apart(device, options.mode, true),
        record(std::move(record_frame)) {}
  TimingOptions options;
  bool wall;
  Recorder whole, apart;
  std::function<void(Recorder&)> record;
  Series series;
  FrameResult last;
};

FrameTimer::FrameTimer(Device& device, const TimingOptions& options, std::function<void(Recorder&)> record)
    : state_(std::make_unique<State>(device, options, std::move(record))) {}
FrameTimer::~FrameTimer() = default;

void FrameTimer::warm_up() { draw(state_->whole, state_->record); }

void FrameTimer::frame() {
  State& s = *state_;
  s.last = draw(s.whole, s.record);
  s.series.record.push_back(s.last.record_ms);
  const double frame_ms = s.wall ? s.last.wall_ms : s.last.gpu_ms;
  if (s.wall) s.last = draw(s.apart, s.record);
  s.series.frame.push_back(std::max(frame_ms - s.last.submission_ms, 0.0));
  add_passes(s.series, s.last, s.wall);
}

Timing FrameTimer::timing() const {
  const State& s = *state_;
  GNOMON_ASSERT(!s.series.frame.empty());
  Timing timing;
  timing.mode = s.options.mode == TimingMode::measure ? "measure" : "play";
  timing.clock = s.wall ? "wall clock, each pass submitted alone" : "gpu timestamps";
  timing.frames = static_cast<int>(s.series.frame.size());
  timing.warm_up = s.options.warm_up;
  timing.frame_ms = summarise(s.series.frame);
  timing.record_ms = summarise(s.series.record);
  for (size_t i = 0; i < s.last.passes.size(); ++i) {
    const PassResult& pass = s.last.passes[i];
    timing.passes.push_back(
        {pass.name, pass.stage, summarise(s.series.passes[i]), pass.draws, pass.dispatches, pass.triangles});
  }
  return timing;
}

Timing time_frames(Device& device, const TimingOptions& options, const std::function<void(Recorder&)>& record) {
  FrameTimer timer(device, options, record);
  for (int i = 0; i < options.warm_up; ++i) timer.warm_up();
  const auto start = std::chrono::steady_clock::now();
  for (int frames = 0; frames < options.frames; ++frames) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (frames >= k_min_frames && elapsed.count() > options.max_seconds) break;
    timer.frame();
  }
  return timer.timing();
}

TimingOptions timing_options(const Settings& settings) {
  const auto params = settings.block("measure").as<measure_params::Params>();
  TimingOptions options;
  options.mode = params.mode == measure_params::mode_play ? TimingMode::play : TimingMode::measure;
  options.frames = params.frames;
  options.warm_up = params.warm_up;
  options.max_seconds = static_cast<double>(params.max_seconds);
  return options;
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
