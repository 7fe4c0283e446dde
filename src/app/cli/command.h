// What the subcommands share: each is one file that adds itself to the parser.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "lab/session.h"

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
void add_report(CLI::App& app, const Globals& globals);
void add_doctor(CLI::App& app, const Globals& globals);

// SCENE, --size, --samples, --camera, --light, --set.
struct ViewArguments {
  std::string scene, size = "800x600";
  uint32_t samples = 1;
  std::string camera;
  std::vector<std::string> lights, assignments;

  void add_to(CLI::App& command);
  ViewOptions view() const;      // throws Error (usage)
  Settings settings() const;     // the same
};

}  // namespace gnomon::cli
