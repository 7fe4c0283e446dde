// Time, draws and memory: a plot of the last frames, a table of their passes.
#pragma once

#include <string>
#include <vector>

#include "app/viewer/measure/frame_plot.h"
#include "app/viewer/state/technique_set.h"

namespace gnomon::viewer {

class MeasurePanel {
 public:
  // A window of its own. `separate_passes`: as the user wants them from the next frame on.
  void show(Timings& timings, bool& separate_passes, Session& session, const TechniqueSet& techniques);
  bool open() const { return open_; }

 private:
  struct Row {
    std::string name, help;
    uint32_t colour = 0;  // 0: no pass
    Summary ms;
    uint32_t draws = 0;
    uint64_t triangles = 0;
  };
  void update_rows(const Timings& timings);
  void table() const;
  void one_frame(const Timings& timings, const FrameResult& frame);
  static void memory(Session& session, const TechniqueSet& techniques);

  FramePlot plot_;
  std::vector<Row> rows_;
  double rows_age_s_ = 0.0;
  bool open_ = false;
};

}  // namespace gnomon::viewer
