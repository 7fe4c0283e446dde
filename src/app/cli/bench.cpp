// gnomon bench: times with the measuring protocol, side by side.
#include "lab/experiment/bench.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "base/error.h"
#include "base/log.h"
#include "base/shell.h"
#include "lab/experiment/compare.h"
#include "lab/view/preset_use.h"
#include "report/report.h"
#include "scene/load.h"

namespace gnomon::cli {
namespace {

struct Arguments {
  std::string what, output, size, camera;
  std::vector<std::string> techniques, only, assignments, preset_names, lights;
  uint32_t samples = 0;
  double scale = 1.0;
  bool quick = false, resume = false, dry_run = false;
};

constexpr double k_quick_scale = 0.125;

// Neither suite nor scene: both lists help.
void check_scene(const std::string& name) {
  std::vector<std::string> suites, scenes;
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name == name) return;
    scenes.push_back(scene.name);
  }
  for (const char* extension : {".obj", ".gltf", ".glb"}) {
    if (name.ends_with(extension)) return;
  }
  for (const Suite& suite : builtin_suites()) suites.push_back(suite.name);
  fail_usage("'{}': valid suites: {}; scenes: {}; or the path of a suite (.json) or scene (.obj, .gltf, .glb)", name,
             fmt::join(suites, ", "), fmt::join(scenes, ", "));
}

SuiteRun run_of(const std::string& name, const Preset& view, const std::string& technique) {
  SuiteRun run;
  run.name = name;
  run.view = view;
  run.view.techniques = {technique};
  return run;
}

// Each run's cost over the first's.
void add_ratios(Suite& suite) {
  for (size_t i = 1; i < suite.runs.size(); ++i) {
    SuiteRow row;
    row.name = suite.runs[i].name + " over " + suite.runs.front().name;
    row.of = row.denominator_of = "technique";
    row.runs = {suite.runs[i].name, suite.runs.front().name};
    suite.rows.push_back(std::move(row));
  }
}

// The suite of a scene: its techniques, or one run for each preset.
Suite suite_of(const Arguments& arguments) {
  Suite suite;
  suite.name = arguments.what.empty() ? "presets" : arguments.what;
  for (const std::string& name : arguments.preset_names) {
    Preset preset = load_preset(name);
    if (!arguments.what.empty()) preset.scene = arguments.what;
    if (!preset.scene) fail_usage("{}: has no scene; name one: gnomon bench SCENE --preset {}", name, name);
    std::vector<std::string> techniques = arguments.techniques.empty() ? preset.techniques : arguments.techniques;
    if (techniques.empty()) fail_usage("{}: has no technique; name one with --techniques", name);
    for (const std::string& technique : techniques)
      suite.runs.push_back(run_of(techniques.size() == 1 ? preset.name : preset.name + " " + technique, preset, technique));
  }
  const bool is_chosen = !suite.runs.empty() || !arguments.techniques.empty();
  if (suite.runs.empty()) {
    Preset view;
    view.name = arguments.what;
    view.scene = arguments.what;
    for (const TechniqueSpec* spec : techniques_named(is_chosen ? arguments.techniques : std::vector<std::string>{"all"})) {
      suite.runs.push_back(run_of(spec->name, view, spec->name));
    }
  }
  for (size_t i = 0; i < suite.runs.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      if (suite.runs[k].name == suite.runs[i].name) fail_usage("'{}' is chosen twice", suite.runs[i].name);
    }
  }
  if (is_chosen) add_ratios(suite);
  return suite;
}

Preset override_of(const Arguments& arguments) {
  Preset preset;
  preset.name = "the command line";
  if (!arguments.size.empty()) preset.size = parse_size(arguments.size);
  if (arguments.samples > 0) preset.samples = SampleCount{arguments.samples, true};
  if (!arguments.camera.empty()) preset.camera = arguments.camera;
  preset.lights = arguments.lights;
  Settings checked;
  for (const std::string& assignment : arguments.assignments) {
    checked.assign(assignment);
    const size_t equals = assignment.find('=');
    preset.set.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  return preset;
}

// What repeats this, but for --only and -o.
std::string command_of(const Arguments& arguments) {
  std::string command = "gnomon bench";
  if (!arguments.what.empty()) command += " " + shell_quoted(arguments.what);
  for (const auto& name : arguments.preset_names) command += " --preset " + shell_quoted(name);
  if (!arguments.techniques.empty()) command += fmt::format(" --techniques {}", fmt::join(arguments.techniques, ","));
  if (arguments.quick) command += " --quick";
  if (arguments.scale != 1.0) command += fmt::format(" --scale {}", arguments.scale);
  if (!arguments.size.empty()) command += " --size " + arguments.size;
  if (arguments.samples > 0) command += fmt::format(" --samples {}", arguments.samples);
  if (!arguments.camera.empty()) command += " --camera " + shell_quoted(arguments.camera);
  for (const auto& light : arguments.lights) command += " --light " + shell_quoted(light);
  for (const auto& assignment : arguments.assignments) command += " --set " + shell_quoted(assignment);
  return command;
}

void print_plan(const Suite& suite) {
  std::cout << fmt::format("{}: {} ({})\n", suite.name, suite.description, suite.source);
  for (const auto& block : side_by_side(suite)) {
    std::cout << "side by side:\n";
    for (const size_t i : block) {
      const SuiteRun& run = suite.runs[i];
      std::cout << fmt::format("  {:<36} {} {}\n", run.name, run.view.scene.value_or(""),
                               run.kernel.empty() ? run.view.techniques.front() : "kernel/" + run.kernel);
    }
  }
  for (const SuiteRow& row : suite.rows) std::cout << fmt::format("row: {}\n", row.name);
}

void run(const Arguments& arguments, const Globals& globals) {
  BenchOptions options;
  const auto suite = arguments.what.empty() ? std::nullopt : find_suite(arguments.what);
  if (suite && !arguments.preset_names.empty())
    fail_usage("--preset with the suite '{}': valid with a scene, or alone", arguments.what);
  if (suite && !arguments.techniques.empty())
    fail_usage("--techniques with the suite '{}': valid with a scene", arguments.what);
  if (!suite && arguments.what.empty() && arguments.preset_names.empty())
    fail_usage("suite or scene is required; suites: gnomon list suites");
  if (!suite && !arguments.what.empty()) check_scene(arguments.what);
  options.suite = suite ? *suite : suite_of(arguments);
  keep_only(options.suite, arguments.only);
  options.output = arguments.output;
  options.override = override_of(arguments);
  options.quick = arguments.quick;
  options.scale = arguments.quick && arguments.scale == 1.0 ? k_quick_scale : arguments.scale;
  options.resume = arguments.resume;
  options.command = command_of(arguments);
  check_bench(options);
  if (arguments.dry_run) return print_plan(options.suite);
  if (arguments.output.empty()) fail_usage("--output is required");
  const auto device = globals.open_device();
  const auto folder = bench(*device, options);
  const auto& lines = folder->lines();
  if (arguments.quick) log_warning("--quick: small pictures, small maps, few frames: no ratio below means anything");
  std::cout << bench_table(lines);
  const std::filesystem::path folders[] = {folder->unfinished()};
  write_report(folders, folder->unfinished() / "report.html");
  folder->publish();
  log_info("report: {}", std::filesystem::absolute(options.output / "report.html").string());
}

}  // namespace

void add_bench(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand(
      "bench", "times of a suite or of a scene's techniques, side by side, beside published figures and goals");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("suite", arguments->what, "built-in suite (gnomon list suites), .json file of one, or a scene");
  command->add_option("-o,--output", arguments->output, "folder for results.jsonl and report.html");
  command->add_option("--techniques", arguments->techniques, "of a scene: names separated by commas; all where not given")
      ->delimiter(',');
  command->add_option("--preset", arguments->preset_names, "a run for each; the first is what the others are compared with");
  command->add_option("--only", arguments->only, "rows or runs of the suite, by name; repeat for several");
  command->add_flag("--quick", arguments->quick,
                    "an eighth of the pictures' and maps' sides, small scenes, few frames: for trying, not for numbers");
  command->add_option("--scale", arguments->scale, "of the sides of pictures and maps, for small devices")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->add_option("--size", arguments->size, "width x height of all pictures, before --scale");
  command
      ->add_option("--samples", arguments->samples, "samples per pixel of all runs, or the most that the device offers below")
      ->check(CLI::Range(1, 64));
  command->add_option("--camera", arguments->camera, "of all runs");
  command->add_option("--light", arguments->lights, "of all runs; repeat for several");
  command->add_option("--set", arguments->assignments,
                      "id.key=value for all runs that have the part, e.g. measure.frames=1000");
  command->add_flag("--resume", arguments->resume,
                    "keeps runs that the output folder has, finished or not, with the same settings and commit");
  command->add_flag("--dry-run", arguments->dry_run, "checks the suite and prints what would be run");
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace gnomon::cli
