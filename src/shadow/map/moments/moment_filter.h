// The part that filters of moment maps share: their tables all have blur, samples and mips.
#pragma once

#include "shadow/map/moments/moment_map.h"

namespace gnomon {

// Params: of the filter's table.
template <class Params>
class MomentFilter : public Filter {
 public:
  explicit MomentFilter(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) final { params_ = params.as<Params>(); }
  float reach() const final { return static_cast<float>(params_.blur) + (params_.mips ? 64.0f : 3.0f); }
  uint32_t depth_samples() const final { return 1u << params_.samples; }
  bool blends_history() const final { return true; }
  void prepare(Device& device, const MapInfo& info) final {
    MomentMapInfo map = describe();
    map.depth_samples = depth_samples();
    map.mips = params_.mips != 0;
    moments_ = MomentMap(device, info, map);
  }
  void record(Recorder& recorder, const DrawnMap& map) final {
    moments_.record(recorder, map, static_cast<uint32_t>(params_.blur), prefilter());
  }
  const Image& map(const DrawnMap&) const final { return moments_.image(); }

 protected:
  // All but depth_samples and mips.
  virtual MomentMapInfo describe() const = 0;
  // See MomentMap::record.
  virtual bool prefilter() const { return false; }
  Params params_;

 private:
  MomentMap moments_;
};

}  // namespace gnomon
