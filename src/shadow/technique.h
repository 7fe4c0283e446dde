// The contract of a technique: it fills the visibility mask of one light (docs/architecture.md, "Adding a technique").
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"
#include "frame/frame.h"
#include "shadow/map/shadow_map_view.h"

namespace gnomon {

class AccelerationStructure;

// Parameter blocks by id ("single", "pcf", "bias"): what --set writes and results.jsonl records.
using SettingsMap = std::map<std::string, ParamBlock, std::less<>>;

// What a technique may ask of the frame's surroundings. The acceleration structure is built on first use and shared.
class TechniqueContext {
 public:
  TechniqueContext(Device& device, const Frame& frame);
  ~TechniqueContext();
  TechniqueContext(const TechniqueContext&) = delete;
  TechniqueContext& operator=(const TechniqueContext&) = delete;

  Device& device() const { return device_; }
  const Frame& frame() const { return frame_; }
  const AccelerationStructure& acceleration_structure();

  // For a technique's memory: shared structures count for whoever asked for them since the last forget_shared_use.
  uint64_t shared_bytes() const;
  uint64_t shared_bytes_used() const { return acceleration_structure_used_ ? shared_bytes() : 0; }
  void forget_shared_use() { acceleration_structure_used_ = false; }

 private:
  Device& device_;
  const Frame& frame_;
  std::unique_ptr<AccelerationStructure> acceleration_structure_;
  bool acceleration_structure_used_ = false;
};

class Technique {
 public:
  virtual ~Technique() = default;
  // Takes over `live` parameters; the caller makes a new technique when a `rebuild` parameter changed.
  virtual void set(const SettingsMap& settings) = 0;
  // Records every pass from the light's point of view to the mask of light `light`.
  virtual void record(Recorder& recorder, const Frame& frame, size_t light) = 0;
  // The map that it reads; none for techniques that have none, and before the first record.
  virtual std::optional<ShadowMapView> shadow_map() const { return std::nullopt; }
};

// A technique by name, before it is built: "projection/filter" or a direct technique's id.
struct TechniqueSpec {
  std::string name;
  std::vector<std::pair<std::string, ParamTable>> tables;  // id and table of everything that --set can reach
  std::string manual;                                      // page for `describe`
  std::string summary;                                     // first sentence of it
  std::vector<LightKind> light_kinds;
  std::string refused;  // why this pair cannot work; empty: it can
  std::function<std::unique_ptr<Technique>(TechniqueContext&, const SettingsMap&)> make;

  SettingsMap default_settings() const;
  bool supports(LightKind kind) const;
};

// Every technique, in alphabetical order; pairs that cannot work are left out.
const std::vector<TechniqueSpec>& all_techniques();
// Throws Error (usage) for an unknown name, listing what there is, or a refused pair, saying why.
const TechniqueSpec& find_technique(std::string_view name);

std::string_view light_kind_name(LightKind kind);

}  // namespace gnomon
