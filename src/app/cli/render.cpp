// gnomon render: one picture.
#include "lab/render.h"

#include <CLI/CLI.hpp>

#include "app/cli/command.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  ViewArguments view;
  std::string technique = "single/pcf", output;
  Picture picture = Picture::shaded;
};

}  // namespace

void add_render(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand("render", "one picture of a scene with one technique");
  const auto arguments = std::make_shared<Arguments>();
  arguments->view.add_to(*command);
  command->add_option("--technique", arguments->technique, "projection/filter or a direct technique")->capture_default_str();
  command->add_option("-o,--output", arguments->output, "picture to write: .png, or .exr for scene-linear values")->required();
  const std::map<std::string, Picture> names = {
      {"shaded", Picture::shaded}, {"mask", Picture::mask}, {"error", Picture::error}, {"reference", Picture::reference}};
  command->add_option("--show", arguments->picture, "shaded, mask, error (signed, against the reference), reference")
      ->transform(CLI::CheckedTransformer(names));
  command->callback([arguments, &globals] {
    RenderOptions options;
    options.view = arguments->view.view();
    options.technique = arguments->technique;
    options.picture = arguments->picture;
    options.output = arguments->output;
    const Settings settings = arguments->view.settings();
    find_technique(options.technique);  // before a device is opened
    const auto device = globals.open_device();
    render(*device, options, settings);
  });
}

}  // namespace gnomon::cli
