// The catalogue: every pair of projection and filter, and every direct technique.
#include "shadow/technique.h"

#include <algorithm>

#include "base/error.h"
#include "frame/rays/acceleration_structure.h"
#include "shadow/map/map_technique.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

// Up to the end of the first sentence.
std::string first_sentence(const std::string& manual) {
  const size_t end = manual.find(". ");
  const size_t line = manual.find(".\n");
  return manual.substr(0, std::min(end, line) == manual.npos ? manual.npos : std::min(end, line) + 1);
}

TechniqueSpec map_spec(const ProjectionInfo& projection, const FilterInfo& filter) {
  TechniqueSpec spec;
  spec.name = projection.id + "/" + filter.id;
  spec.tables = {{projection.id, projection.params},
                 {filter.id, filter.params},
                 {"bias", bias_params::param_table_storage()},
                 {"submission", submission_params::param_table_storage()},
                 {"temporal", temporal_params::param_table_storage()}};
  spec.manual = projection.manual + "\n\n" + filter.manual;
  spec.summary = first_sentence(projection.manual) + " " + first_sentence(filter.manual);
  spec.light_kinds = projection.light_kinds;
  spec.refused = filter.refuses(projection);
  spec.make = [&projection, &filter](TechniqueContext& context, const SettingsMap& settings) -> std::unique_ptr<Technique> {
    return std::make_unique<MapTechnique>(context, projection, filter, settings);
  };
  return spec;
}

TechniqueSpec direct_spec(const DirectInfo& direct) {
  TechniqueSpec spec;
  spec.name = direct.id;
  spec.tables = {{direct.id, direct.params}};
  spec.manual = direct.manual;
  spec.summary = first_sentence(direct.manual);
  spec.light_kinds = direct.light_kinds;
  spec.make = [&direct](TechniqueContext& context, const SettingsMap& settings) {
    return direct.make(context, settings.at(direct.id));
  };
  return spec;
}

std::vector<TechniqueSpec> make_catalogue() {
  std::vector<TechniqueSpec> specs;
  for (const auto& projection : projections()) {
    for (const auto& filter : filters()) specs.push_back(map_spec(projection, filter));
  }
  for (const auto& direct : directs()) specs.push_back(direct_spec(direct));
  std::sort(specs.begin(), specs.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return specs;
}

const std::vector<TechniqueSpec>& catalogue() {
  static const std::vector<TechniqueSpec> all = make_catalogue();
  return all;
}

}  // namespace

TechniqueContext::TechniqueContext(Device& device, const Frame& frame) : device_(device), frame_(frame) {}
TechniqueContext::~TechniqueContext() = default;

const AccelerationStructure& TechniqueContext::acceleration_structure() {
  if (!acceleration_structure_) acceleration_structure_ = std::make_unique<AccelerationStructure>(device_, frame_.scene());
  acceleration_structure_used_ = true;
  return *acceleration_structure_;
}

uint64_t TechniqueContext::shared_bytes() const { return acceleration_structure_ ? acceleration_structure_->bytes() : 0; }

SettingsMap TechniqueSpec::default_settings() const {
  SettingsMap settings;
  for (const auto& [id, table] : tables) settings.emplace(id, ParamBlock(table));
  return settings;
}

bool TechniqueSpec::supports(LightKind kind) const {
  return std::find(light_kinds.begin(), light_kinds.end(), kind) != light_kinds.end();
}

const std::vector<TechniqueSpec>& all_techniques() {
  static const std::vector<TechniqueSpec> working = [] {
    std::vector<TechniqueSpec> specs;
    for (const auto& spec : catalogue()) {
      if (spec.refused.empty()) specs.push_back(spec);
    }
    return specs;
  }();
  return working;
}

const TechniqueSpec& find_technique(std::string_view name) {
  for (const auto& spec : catalogue()) {
    if (spec.name != name) continue;
    if (!spec.refused.empty()) fail_usage("technique '{}' cannot work: {}", name, spec.refused);
    return spec;
  }
  std::vector<std::string_view> names;
  for (const auto& spec : all_techniques()) names.push_back(spec.name);
  fail_usage("unknown technique '{}'; valid: {}", name, fmt::join(names, ", "));
}

std::string_view light_kind_name(LightKind kind) {
  switch (kind) {
    case LightKind::directional:
      return "directional";
    case LightKind::point:
      return "point";
    case LightKind::spot:
      return "spot";
    case LightKind::projector:
      return "projector";
  }
  return "unknown";
}

}  // namespace gnomon
