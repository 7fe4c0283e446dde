// What the viewer shows, said as a command line would say it: so every picture can be repeated by `gnomon render`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/view/session.h"

namespace gnomon::viewer {

struct ViewState {
  ViewOptions view;
  std::vector<std::string> techniques;       // each light takes the first that supports its kind
  Settings base;                             // of command line and presets
  std::map<std::string, std::string> edits;  // "pcf.size", "sun@pcf.size" -> "5": what the panels changed since

  Settings settings() const;
  // Techniques in the list that do not serve lights of that kind stay.
  void choose_technique(const TechniqueSpec& spec, LightKind kind, std::span<const Light> lights);
  // Adds a technique for each kind of light that has none: of `before`, else a usual one.
  void complete_techniques(std::span<const Light> lights, std::span<const std::string> before = {});
  // `gnomon render ...` of the same picture, without its output.
  std::string command(uvec2 size) const;
  // The same as words: `render SCENE --size ... --technique ... --set ...`, or another subcommand that takes techniques.
  std::vector<std::string> words(const std::string& subcommand, const std::string& technique_option, uvec2 size) const;
  bool same_picture(const ViewState& other) const { return view.camera == other.view.camera && same_but_camera(other); }
  bool same_but_camera(const ViewState& other) const;
};

// The same technique and its settings on another scene: what belongs to the old scene (camera, lights, their settings) is left
// behind.
ViewState state_for_scene(const ViewState& state, const std::string& scene);

// "sun@pcf.size" -> "pcf"
std::string part_of(const std::string& key);

// Those of the names that some light takes, each once, in the order of the lights.
std::vector<std::string> names_in_force(const std::vector<std::string>& names, std::span<const Light> lights);

// The first of the names that supports a kind of light; null where none does.
const TechniqueSpec* technique_for(const std::vector<std::string>& names, LightKind kind);

}  // namespace gnomon::viewer
