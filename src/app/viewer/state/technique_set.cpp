#include "app/viewer/state/technique_set.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/state/view_state.h"
#include "base/error.h"

namespace gnomon::viewer {
namespace {

constexpr double k_least_map = 64.0;  // texels along a side

bool needs_rebuild(const SettingsMap& old_settings, const SettingsMap& new_settings) {
  for (const auto& [id, block] : new_settings) {
    const ParamBlock& old_block = old_settings.at(id);
    for (const ParamInfo& info : block.table()) {
      if (info.update == ParamUpdate::rebuild && block.number(info.name) != old_block.number(info.name)) return true;
    }
  }
  return false;
}

// The side of a map is the parameter `size` of its projection, the block named before the slash.
void divide_map_size(SettingsMap& settings, const TechniqueSpec& spec, uint32_t divisor) {
  const size_t slash = spec.name.find('/');
  if (divisor == 1 || slash == std::string::npos) return;
  ParamBlock& block = settings.at(spec.name.substr(0, slash));
  const double size = std::max(std::floor(block.number("size") / divisor), k_least_map);
  block.set_number("size", std::min(size, block.number("size")), spec.name + ".size");
}

}  // namespace

const TechniqueSpec& required_technique(const std::vector<std::string>& names, const Light& light) {
  const TechniqueSpec* spec = technique_for(names, light.kind);
  if (!spec) {
    fail_device("light '{}': {} supports no {} lights; valid: {}", light.name, fmt::join(names, ", "),
                light_kind_name(light.kind), techniques_for(light.kind));
  }
  return *spec;
}

bool TechniqueSet::builds(std::span<const Light> lights, const std::vector<std::string>& names,
                          const Settings& settings) const {
  if (lights.size() != entries_.size()) return true;
  for (size_t i = 0; i < lights.size(); ++i) {
    const TechniqueSpec* spec = technique_for(names, lights[i].kind);
    if (!spec || spec != entries_[i].spec) return true;
    if (needs_rebuild(entries_[i].settings, settings.for_technique(*spec, lights[i].name))) return true;
  }
  return false;
}

bool TechniqueSet::has_history() const {
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    const auto temporal = entry.settings.find("temporal");
    return temporal != entry.settings.end() && temporal->second.number("history") > 0.0;
  });
}

void TechniqueSet::update(Session& session, const std::vector<std::string>& names, uint32_t map_divisor) {
  const auto lights = session.frame().lights();
  std::vector<Entry> next(lights.size());
  std::vector<std::unique_ptr<Technique>> made(lights.size());
  TechniqueContext& context = session.context();
  for (size_t i = 0; i < lights.size(); ++i) {
    Entry& entry = next[i];
    entry.spec = &required_technique(names, lights[i]);
    entry.settings = session.settings_of(*entry.spec, i);
    divide_map_size(entry.settings, *entry.spec, map_divisor);
    const Entry* old = i < entries_.size() ? &entries_[i] : nullptr;
    if (old && old->spec == entry.spec && !needs_rebuild(old->settings, entry.settings)) {
      entry.bytes = old->bytes;
      continue;
    }
    context.forget_shared_use();
    const uint64_t before = session.device().allocated_bytes() - context.shared_bytes();
    made[i] = entry.spec->make(context, entry.settings);
    entry.bytes = session.device().allocated_bytes() - context.shared_bytes() - before + context.shared_bytes_used();
  }
  techniques_.resize(lights.size());
  const std::vector<Entry> old = std::exchange(entries_, std::move(next));
  for (size_t i = 0; i < lights.size(); ++i) {
    if (made[i]) {
      techniques_[i] = std::move(made[i]);
    } else if (entries_[i].settings != old[i].settings) {
      techniques_[i]->set(entries_[i].settings);
    }
  }
}

}  // namespace gnomon::viewer
