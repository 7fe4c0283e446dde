// Arguments that subcommands share.
#include <CLI/CLI.hpp>
#include <charconv>

#include "app/cli/command.h"
#include "base/error.h"
#include "lab/light_text.h"

namespace gnomon::cli {

std::unique_ptr<Device> Globals::open_device() const { return std::make_unique<Device>(device); }

void ViewArguments::add_to(CLI::App& command) {
  command.add_option("scene", scene, "built-in scene (gnomon list scenes) or path to .obj, .gltf, .glb")->required();
  command.add_option("--size", size, "width x height of the picture, e.g. 1280x720")->capture_default_str();
  command.add_option("--samples", samples, "samples per pixel: 1, 2, 4, 8 as the device offers")->capture_default_str();
  command.add_option("--camera", camera, "'frame', 'x,y,z:x,y,z' (eye and target), or name or number of a camera of the scene");
  command.add_option("--light", lights, std::string("'sun', 'all', name or number of a light of the scene, or ") + k_light_text_help +
                                           "; repeat for several (default: the scene's first sun, else all its lights)");
  command.add_option("--set", assignments, "id.key=value, e.g. pcf.size=5 or light.elevation=30 (gnomon describe TECHNIQUE)");
}

ViewOptions ViewArguments::view() const {
  ViewOptions options;
  options.scene = scene;
  const size_t x = size.find('x');
  const auto number = [&](std::string_view text) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || value < 1 || value > 16384) fail_usage("--size {}: valid: WIDTHxHEIGHT, each from 1 to 16384", size);
    return value;
  };
  if (x == size.npos) number("");
  options.size = {number(std::string_view(size).substr(0, x)), number(std::string_view(size).substr(x + 1))};
  options.samples = samples;
  options.camera = camera;
  options.lights = lights;
  return options;
}

Settings ViewArguments::settings() const {
  Settings settings;
  for (const std::string& assignment : assignments) settings.assign(assignment);
  return settings;
}

}  // namespace gnomon::cli
