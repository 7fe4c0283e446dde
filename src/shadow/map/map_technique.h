// A projection times a filter: renders the map, lets the filter convert it, resolves the mask.
#pragma once

#include "frame/depth_pass.h"
#include "shadow/registry.h"

namespace gnomon {

namespace bias_params {
#define GNOMON_PARAMS_FILE "shadow/map/bias.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace bias_params

class MapTechnique : public Technique {
 public:
  MapTechnique(TechniqueContext& context, const ProjectionInfo& projection, const FilterInfo& filter, const SettingsMap& settings);
  void set(const SettingsMap& settings) override;
  void record(Recorder& recorder, const Frame& frame, size_t light) override;

 private:
  void record_resolve(Recorder& recorder, const Frame& frame, size_t light);

  std::string projection_id_, filter_id_, name_;
  std::unique_ptr<Projection> projection_;
  std::unique_ptr<Filter> filter_;
  bias_params::Params bias_;
  Image depth_;
  Buffer views_, params_;
  size_t filter_offset_ = 0, bias_offset_ = 0;  // of the blocks in params_
  std::vector<CulledDraws> draws_;              // per layer
  DepthPassPipelines depth_pipelines_;
  Pipeline resolve_;
};

}  // namespace gnomon
