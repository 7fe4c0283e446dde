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

class RecordedFrames : public TimedFrames {
 public:
  RecordedFrames(Device& device, TimingMode mode, std::function<void(Recorder&)> record)
      : whole_(device, mode, false), apart_(device, mode, true), record_(std::move(record)) {}
  FrameResult draw(bool apart) override {
    Recorder& recorder = apart ? apart_ : whole_;
    recorder.begin();
    record_(recorder);
    return recorder.finish();
  }

 private:
  Recorder whole_, apart_;
  std::function<void(Recorder&)> record_;
};

double steady_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

struct FrameTimer::State {
  std::unique_ptr<TimedFrames> frames;
  TimingOptions options;
  bool wall;
  Series series;
  FrameResult last;

  FrameResult draw(bool apart) {
    check_interrupted();
    return frames->draw(apart);
  }
};

FrameTimer::FrameTimer(std::unique_ptr<TimedFrames> frames, const TimingOptions& options, bool wall)
    : state_(std::make_unique<State>(State{std::move(frames), options, wall, {}, {}})) {}
FrameTimer::FrameTimer(Device& device, const TimingOptions& options, std::function<void(Recorder&)> record)
    : FrameTimer(std::make_unique<RecordedFrames>(device, options.mode, std::move(record)), options,
                 device.info().software || device.info().timestamp_ms == 0.0) {}
FrameTimer::~FrameTimer() = default;

void FrameTimer::warm_up() { state_->draw(false); }

void FrameTimer::frame() {
  State& s = *state_;
  s.last = s.draw(false);
  s.series.record.push_back(s.last.record_ms);
  const double frame_ms = s.wall ? s.last.wall_ms : s.last.gpu_ms;
  if (s.wall) s.last = s.draw(true);
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
  return time_frames(timer, options, steady_seconds);
}

Timing time_frames(FrameTimer& timer, const TimingOptions& options, const std::function<double()>& now_s) {
  for (int i = 0; i < options.warm_up; ++i) timer.warm_up();
  const double start = now_s();
  for (int frames = 0; frames < options.frames; ++frames) {
    if (frames >= k_min_frames && now_s() - start > options.max_seconds) break;
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
