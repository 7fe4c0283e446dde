// The technique of each light, built as the session's settings say.
#pragma once

#include "lab/view/session.h"

namespace gnomon::viewer {

// The first of the names for that light. Throws Error (device) where none supports its kind.
const TechniqueSpec& required_technique(const std::vector<std::string>& names, const Light& light);

class TechniqueSet {
 public:
  // Builds again where a technique or a `rebuild` parameter changed; other changes take effect in the next frame. Throws Error
  // where one cannot be built: the old ones then stay. Sides of maps are divided by `map_divisor`.
  void update(Session& session, const std::vector<std::string>& names, uint32_t map_divisor = 1);
  // Whether update to these would build something, which takes a while.
  bool builds(std::span<const Light> lights, const std::vector<std::string>& names, const Settings& settings) const;
  void clear() { entries_.clear(), techniques_.clear(); }

  // Whether a picture also depends on those before it.
  bool has_history() const;

  std::span<const std::unique_ptr<Technique>> techniques() const { return techniques_; }
  const TechniqueSpec& spec(size_t light) const { return *entries_[light].spec; }
  uint64_t memory_bytes(size_t light) const { return entries_[light].bytes; }

 private:
  struct Entry {
    const TechniqueSpec* spec = nullptr;
    SettingsMap settings;
    uint64_t bytes = 0;
  };
  std::vector<Entry> entries_;
  std::vector<std::unique_ptr<Technique>> techniques_;
};

}  // namespace gnomon::viewer
