// gnomon view: the window.
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "base/error.h"
#ifdef GNOMON_VIEWER
#include "app/viewer/viewer.h"
#endif

namespace gnomon::cli {
namespace {

struct Arguments {
  ViewArguments view;
  std::vector<std::string> techniques = {"single/pcf", "cube/pcf"};  // the second for point lights
  float scale = 0.0f, frame_ms = 40.0f;                              // scale 0: follows the time of a frame
  uint32_t frames = 0;
  std::string screenshot, split;
  bool error = false, no_panels = false;
  std::string overlay, pick, map;
};

void view(const Arguments& arguments, bool technique_given, const Globals& globals) {
#ifdef GNOMON_VIEWER
  std::vector<std::string> techniques = arguments.techniques;
  const Preset preset = arguments.view.preset();
  if (!technique_given && !preset.techniques.empty()) techniques = preset.techniques;
  for (const std::string& name : techniques) find_technique(name);
  if (!arguments.screenshot.empty() && !arguments.screenshot.ends_with(".png")) {
    fail_usage("--screenshot {}: valid: a path that ends in .png", arguments.screenshot);
  }
  const viewer::ExplainOptions explain = viewer::parse_explain_options(arguments.overlay, arguments.pick, arguments.map);
  viewer::ViewState state{arguments.view.view(), techniques, arguments.view.settings(techniques), {}};
  arguments.view.write_preset(techniques, true);
  viewer::Window window(state.view.size, "gnomon: " + state.view.scene);
  DeviceOptions options = globals.device;
  options.window = window.needs();
  Device device(options);
  viewer::Screen screen(window, device);
  viewer::Workspace workspace(device);
  workspace.explain = explain;
  workspace.sides.other = state;
  workspace.sides.error = arguments.error;
  if (!arguments.split.empty()) {
    const bool reference = arguments.split == "reference";
    workspace.sides.second = reference ? viewer::SecondSide::reference : viewer::SecondSide::settings;
    if (!reference) workspace.sides.other.techniques = {find_technique(arguments.split).name};
  }
  viewer::Wishes& wishes = workspace.wishes;
  wishes.adapt_size = arguments.scale == 0.0f;
  if (!wishes.adapt_size) wishes.scale = arguments.scale;
  wishes.target_ms = arguments.frame_ms;
  wishes.interface = !arguments.no_panels;
  auto opened = viewer::open_first(screen, std::move(state));
  if (opened && workspace.sides.second == viewer::SecondSide::settings) {
    for (const Light& light : opened->session->frame().lights())
      viewer::required_technique(workspace.sides.other.techniques, light);
  }
  const viewer::ViewerOptions how{arguments.frames, arguments.screenshot};
  while (opened) opened = viewer::Viewer(screen, std::move(*opened), workspace, how).run();
#else
  static_cast<void>(arguments), static_cast<void>(technique_given), static_cast<void>(globals);
  fail_device("this gnomon was built without its viewer; use 'gnomon render' or 'gnomon compare'");
#endif
}

}  // namespace

void add_view(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand("view", "a window to walk through a scene, with every setting at hand");
  const auto arguments = std::make_shared<Arguments>();
  arguments->view.scene = "courtyard";
  arguments->view.size = "1280x720";  // of the window: room for a picture between the panels
  arguments->view.add_to(*command);
  command->get_option("scene")->capture_default_str();
  auto* technique = command
                        ->add_option("--technique", arguments->techniques,
                                     "projection/filter or a direct technique; several, separated by commas: "
                                     "each light takes the first for its kind")
                        ->delimiter(',')
                        ->capture_default_str();
  command
      ->add_option("--scale", arguments->scale,
                   "size of the picture, relative to the window's (default: follows the time of a frame)")
      ->check(CLI::Range(0.1f, 2.0f));
  command->add_option("--frame-ms", arguments->frame_ms, "time of a frame that the size of the picture aims at")
      ->check(CLI::Range(5.0f, 1000.0f))
      ->capture_default_str();
  command->add_option("--frames", arguments->frames, "ends after so many frames (default: when the window is closed)")
      ->check(CLI::Range(1u, 1000000u));
  command->add_option("--split", arguments->split, "a second side beside the picture: a technique, or 'reference'");
  command->add_flag("--no-panels", arguments->no_panels, "the picture alone (F1 shows the panels)");
  command->add_flag("--error", arguments->error, "error against the reference over the picture");
  command->add_option(
      "--overlay", arguments->overlay,
      "what is shown over the picture: layers, texels, footprint, flags or overdraw; and lines, of the light's views");
  command->add_option("--pick", arguments->pick, "explains a pixel of the picture: x,y");
  command->add_option("--map", arguments->map, "shows a layer of the shadow map: its number");
  command->add_option("--screenshot", arguments->screenshot, "writes the last frame, interface included: .png");
  command->callback([arguments, technique, &globals] { view(*arguments, technique->count() > 0, globals); });
}

}  // namespace gnomon::cli
