// Everything that --set can reach: `id.key=value`, where id is a technique's part (single, pcf, bias, ...) or one of light,
// camera, scene, frame, reference, measure.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"
#include "scene/load.h"
#include "shadow/technique.h"

namespace gnomon {

// Ids that belong to the laboratory, not to a technique: light, camera, frame, reference, measure; scene, for files.
std::vector<std::pair<std::string, ParamTable>> lab_tables();

class Settings {
 public:
  Settings();

  // "pcf.size=5", or "lamp@pcf.size=5" for the technique of one light. Throws Error (usage) for a key that no part of the
  // program reads, or a value out of range; `source` is where the assignment stands, for the message.
  void assign(std::string_view assignment, std::string_view source = "--set");

  const ParamBlock& block(std::string_view id) const;  // of the laboratory
  // The parts that any technique has; "scene", "light", ... are none.
  static bool is_technique_part(std::string_view id);
  bool was_set(std::string_view key) const;  // "light.azimuth": given by the user, so it overrides the scene
  void set_effective(std::string_view id, std::string_view name, double value);  // what the scene decided, for the record

  // A technique's defaults with the user's assignments; with those for a light of that name after the others.
  SettingsMap for_technique(const TechniqueSpec& spec, std::string_view light = {}) const;
  // Names of lights that assignments are for.
  std::vector<std::string> lights_named() const;
  // Options of a built-in scene, and how a file is read.
  const std::map<std::string, double>& scene_options() const { return scene_options_; }
  SceneFileOptions scene_file_options() const;
  // Adds the defaults of what the scene, built in or from a file, can be asked for, for the record.
  void complete_scene_options(const std::string& scene);
  // All of these as texts.
  std::map<std::string, std::string> scene_texts() const;
  // Throws Error (usage) when an assignment belongs to no technique of the list: a setting that does nothing is a mistake.
  void check_used(const std::vector<const TechniqueSpec*>& techniques) const;

  // All effective values for one technique: {"single": {...}, "light": {...}, ...}.
  nlohmann::json to_json(const SettingsMap& technique) const;
  // All assignments as given, the later over the earlier.
  const std::vector<std::string>& assignments() const { return assignments_; }
  // The assignments as given that reach this technique or the laboratory, for the command that repeats a row.
  std::vector<std::string> assignments_for(const TechniqueSpec& spec) const;

 private:
  void assign_to_scene(const std::string& name, const std::string& value, const std::string& where);

  struct Assignment {
    std::string id, name, value, light, source;  // light: empty for all; source: where it stands, for messages
  };
  std::map<std::string, ParamBlock, std::less<>> blocks_;
  std::vector<Assignment> of_techniques_;
  std::map<std::string, double> scene_options_;
  SceneFileOptions scene_texts_;  // its texts: the numbers are a block
  bool scene_is_file_ = false;
  std::vector<std::string> assignments_;
};

}  // namespace gnomon
