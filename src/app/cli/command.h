// What the subcommands share: each is one file that adds itself to the parser.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "lab/plan/preset.h"
#include "lab/view/session.h"

namespace CLI {
class App;
}

namespace gnomon::cli {

// Options that every subcommand has.
struct Globals {
  DeviceOptions device;
  std::unique_ptr<Device> open_device() const;
};

void add_list(CLI::App& app, const Globals& globals);
void add_describe(CLI::App& app, const Globals& globals);
void add_render(CLI::App& app, const Globals& globals);
void add_compare(CLI::App& app, const Globals& globals);
void add_bench(CLI::App& app, const Globals& globals);
void add_report(CLI::App& app, const Globals& globals);
void add_view(CLI::App& app, const Globals& globals);
void add_doctor(CLI::App& app, const Globals& globals);

// SCENE, --size, --samples, --camera, --light, --set, --preset, --write-preset. What the command line does not say, presets do.
struct ViewArguments {
  std::string scene, size = "800x600";
  uint32_t samples = 1;
  std::string camera;
  std::vector<std::string> lights, casts, assignments, preset_names;
  std::string up, time, gltf_scene, animation;  // each another way to say --set scene.KEY=VALUE
  std::string written_preset;

  void add_to(CLI::App& command);
  // Each throws Error (usage).
  Preset preset() const;  // all of --preset, the later over the earlier
  ViewOptions view() const;
  // `techniques`: those of the run. Settings of presets that none of them has are left out when the command line chose others.
  Settings settings(const std::vector<std::string>& techniques) const;
  // --write-preset, where it was given. `together`: each light takes the first for its kind.
  void write_preset(const std::vector<std::string>& techniques, bool together) const;

 private:
  bool given(const char* option) const;
  bool other_scene(const Preset& preset) const;  // than the preset was made for: what names its parts is left out
  const CLI::App* command_ = nullptr;
};

// --against pixel|area|hard.
void add_against(CLI::App& command, std::string& against);

// "800x600" of --size.
uvec2 parse_size(const std::string& text);

}  // namespace gnomon::cli
