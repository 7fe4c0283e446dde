// A projection times a filter: renders the map, lets the filter convert it, resolves the mask.
#pragma once

#include "frame/casters/caster_draws.h"
#include "shadow/map/depth_history.h"
#include "shadow/registry.h"

namespace gnomon {

namespace bias_params {
#define GNOMON_PARAMS_FILE "shadow/map/bias.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace bias_params

namespace submission_params {
#define GNOMON_PARAMS_FILE "shadow/map/submission.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace submission_params

namespace temporal_params {
#define GNOMON_PARAMS_FILE "shadow/map/temporal.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace temporal_params

class MapTechnique : public Technique {
 public:
  MapTechnique(TechniqueContext& context, const ProjectionInfo& projection, const FilterInfo& filter,
               const SettingsMap& settings);
  void set(const SettingsMap& settings) override;
  void record(Recorder& recorder, const Frame& frame, size_t light) override;
  std::optional<ShadowMapView> shadow_map() const override;

 private:
  void create_map(Device& device, const GpuScene& scene);
  // Writes the views of this frame; true when they differ from the last frame's.
  bool update_views(const Frame& frame, const Light& light);
  void record_map(Recorder& recorder, const Frame& frame, size_t light);
  void record_resolve(Recorder& recorder, const Frame& frame, size_t light);
  DrawnMap drawn() const;

  std::string projection_id_, filter_id_, name_;
  std::unique_ptr<Projection> projection_;
  std::unique_ptr<Filter> filter_;
  bias_params::Params bias_;
  submission_params::Params submission_;
  float history_;  // temporal.history
  Image depth_, object_ids_;
  Buffer views_, last_views_, params_;          // views change places each frame; last_views_ only with history_
  std::vector<std::byte> view_bytes_;           // as in views_, where the CPU can read them
  size_t filter_offset_ = 0, bias_offset_ = 0;  // of the blocks in params_
  std::unique_ptr<CasterDraws> draws_;
  DepthHistory depth_history_;  // where the filter blends nothing itself
  Pipeline resolve_;
  bool kept_ = false;            // the last frame drew no map
  bool map_is_current_ = false;  // there is a map of an earlier frame with the same settings
  float unsettled_ = 0.0f;       // share of the map that is from before the views' last change
};

}  // namespace gnomon
