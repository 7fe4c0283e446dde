// gnomon render: one picture, or a sequence.
#include "lab/experiment/render.h"

#include <CLI/CLI.hpp>
#include <set>

#include "app/cli/command.h"
#include "base/error.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  ViewArguments view;
  std::vector<std::string> techniques = {"single/pcf"};
  std::string output;
  Picture picture = Picture::shaded;
  std::string against = truth_name(k_truths[0]);
  uint32_t frames = 0;
  std::string path, sun_path;
  double seconds = 0.0;
};

// Whether two of them serve one kind of light: it is then open which is meant.
bool compete(const std::vector<std::string>& techniques) {
  std::set<LightKind> served;
  for (const std::string& name : techniques) {
    if (name == "all") return true;
    for (const LightKind kind : find_technique(name).light_kinds) {
      if (!served.insert(kind).second) return true;
    }
  }
  return false;
}

}  // namespace

void add_render(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand("render", "one picture of a scene with one technique, or a sequence");
  const auto arguments = std::make_shared<Arguments>();
  arguments->view.add_to(*command);
  command
      ->add_option(
          "--technique", arguments->techniques,
          "projection/filter or a direct technique; several, separated by commas: each light takes the first for its kind")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "picture to write: .png, or .exr for scene-linear values")->required();
  const std::map<std::string, Picture> names = {
      {"shaded", Picture::shaded}, {"mask", Picture::mask}, {"error", Picture::error}, {"reference", Picture::reference}};
  command->add_option("--show", arguments->picture, "shaded, mask, error (signed, against the reference), reference")
      ->transform(CLI::CheckedTransformer(names));
  add_against(*command, arguments->against);
  command
      ->add_option("--frames", arguments->frames,
                   "a sequence of so many pictures along the paths: NAME_0000.png, NAME_0001.png, ...")
      ->check(CLI::Range(1u, 100000u));
  command->add_option("--path", arguments->path,
                      "name of a camera path of the scene: walk, turn, fly; or a .json file, as the viewer records it "
                      "(default: walk, unless the sun moves)");
  command->add_option("--sun-path", arguments->sun_path,
                      "name of a sun path of the scene: day; or a .json file, as the viewer records it");
  command
      ->add_option("--seconds", arguments->seconds, "only the first seconds of each path, for slow motion (default: all of it)")
      ->check(CLI::Range(1e-3, 1e6));
  command->callback([arguments, command, &globals] {
    RenderOptions options;
    options.view = arguments->view.view();
    options.techniques = arguments->techniques;
    if (command->get_option("--technique")->count() == 0) options.techniques.emplace_back("cube/pcf");  // for point lights
    const Preset preset = arguments->view.preset();
    if (command->get_option("--technique")->count() == 0 && !preset.techniques.empty()) {
      if (!preset.together && compete(preset.techniques))
        fail_usage("preset {}: has {} techniques; choose with --technique", preset.name, preset.techniques.size());
      options.techniques = preset.techniques;
    }
    options.picture = arguments->picture;
    options.against = truth_named(arguments->against);
    options.output = arguments->output;
    options.frames = arguments->frames;
    options.path = arguments->path, options.sun_path = arguments->sun_path;
    options.seconds = arguments->seconds;
    const Settings settings = arguments->view.settings(options.techniques);  // before a device is opened
    arguments->view.write_preset(preset.techniques.empty() ? arguments->techniques : options.techniques, true);
    const auto device = globals.open_device();
    render(*device, options, settings);
  });
}

}  // namespace gnomon::cli
