// Presets: settings of a run as a small JSON file that people write and share (docs/measuring.md, "Presets").
//   {"description": "...", "source": "paper, year", "scene": "terrain", "techniques": ["cascaded/vsm"], "lights": ["sun"],
//    "casts": ["ground*=off"], "camera": "default", "size": [800, 600], "samples": 8 or "up to 8", "set": {"cascaded.size":
//    2048}}
// Every key is optional. "technique" instead of "techniques": a list of it is one choice, of which each light takes the first
// that supports its kind; "techniques" are alternatives.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/maths.h"

namespace gnomon {

struct SampleCount {
  uint32_t count = 1;
  bool at_most = false;  // "up to 8": the most that the device offers, up to this
  bool operator==(const SampleCount&) const = default;
};

struct Preset {
  std::string name;  // of a built-in one: of its file; else the path. Stands in errors.
  std::string description, source;
  std::optional<std::string> scene, camera;
  std::vector<std::string> techniques, lights, casts;
  bool together = false;  // the techniques: "technique"
  std::optional<uvec2> size;
  std::optional<SampleCount> samples;
  std::vector<std::pair<std::string, std::string>> set;  // "cascaded.size", "2048"; in alphabetical order when read
};

// Ordered by name.
const std::vector<Preset>& builtin_presets();
// A built-in name, or a path. Throws Error (usage) for what is not a preset, naming file, key and what would be valid.
Preset load_preset(const std::string& name_or_path);
Preset parse_preset(std::string_view json, const std::string& name);
// An object of a larger document (a suite), already checked for other keys than a preset's.
Preset read_preset(const nlohmann::json& object, const std::string& name);

// What `top` says replaces what `base` says; settings are added behind.
void overlay(Preset& base, const Preset& top);

// As a file: read_preset gives the same preset again (its settings once each, the last value).
std::string preset_text(const Preset& preset);

}  // namespace gnomon
