// Four cascades of the courtyard by every path.
#include "lab/timing/measure_layering.h"

#include <algorithm>

#include "base/log.h"
#include "frame/casters/layering_choice.h"
#include "lab/timing/timing.h"
#include "lab/view/session.h"

namespace gnomon {

std::vector<LayeringTime> measure_layering(Device& device) {
  ViewOptions view;
  view.scene = "courtyard";
  view.size = {320, 240};
  std::vector<LayeringTime> times;
  for (const auto path :
       {LayeringPath::per_layer, LayeringPath::vertex_layer, LayeringPath::geometry, LayeringPath::multiview}) {
    times.push_back({path, 0.0, layering_path_missing(device.info(), path)});
    if (!times.back().missing.empty()) continue;
    Settings settings;
    settings.assign(fmt::format("submission.path={}", layering_path_name(path)));
    Session session(device, view, settings);
    const auto techniques = session.make_techniques(find_technique("cascaded/hard"));
    TimingOptions options;
    options.warm_up = 2, options.frames = 15, options.max_seconds = 1.0;
    const Timing timing = time_frames(device, options, [&](Recorder& recorder) { session.record_frame(recorder, techniques); });
    times.back().ms = timing.stage_ms(PassStage::build);
  }
  const auto fastest = std::min_element(times.begin(), times.end(), [](const auto& a, const auto& b) {
    return a.missing.empty() && (!b.missing.empty() || a.ms < b.ms);
  });
  store_layering_path(device.info(), fastest->path);
  return times;
}

void ensure_layering_measured(Device& device) {
  if (measured_layering_path(device.info())) return;
  log_info("measuring which layering path is fastest on '{}' (once; gnomon doctor shows it)", device.info().name);
  measure_layering(device);
}

}  // namespace gnomon
