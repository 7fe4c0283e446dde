// Scenes by name or path.
#include "scene/load.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/lower_case.h"
#include "base/visible_text.h"
#include "base/warning_limit.h"
#include "scene/path.h"

namespace gnomon {
namespace {

std::string builtin_names() {
  std::string names;
  for (const BuiltinScene& scene : builtin_scenes()) names += (names.empty() ? "" : ", ") + scene.name;
  return names;
}

std::string option_names(const BuiltinScene& scene) {
  std::string names;
  for (const BuiltinOption& option : scene.options) {
    names += fmt::format("{}{} ({} to {})", names.empty() ? "" : ", ", option.name, option.min, option.max);
  }
  return names.empty() ? "none" : names;
}

// Every option of the scene: the given ones, checked, and the defaults of the others.
std::map<std::string, double> complete_options(const BuiltinScene& scene, const std::map<std::string, double>& given) {
  std::map<std::string, double> complete;
  for (const BuiltinOption& option : scene.options) complete[option.name] = option.default_value;
  for (const auto& [given_name, value] : given) {
    const std::string& name = given_name;  // clang 14 cannot capture the binding itself
    const auto option = std::find_if(scene.options.begin(), scene.options.end(), [&](const auto& o) { return o.name == name; });
    if (option == scene.options.end()) {
      fail_usage("scene.{}: {} has no such option; valid: {}", name, scene.name, option_names(scene));
    }
    if (!(value >= option->min && value <= option->max)) {
      fail_usage("scene.{}: {} is out of range; valid: {} to {}", name, value, option->min, option->max);
    }
    complete[name] = value;
  }
  return complete;
}

std::vector<std::string_view> scene_file_option_names() {
  std::vector<std::string_view> names;
  for (const ParamInfo& info : scene_file_params::param_table_storage()) names.push_back(info.name);
  for (const SceneFileText& text : k_scene_file_texts) names.push_back(text.name);
  return names;
}

// What is said of a glTF file, and does nothing for an OBJ.
void refuse_for_obj(const std::string& path, const SceneFileOptions& options) {
  const auto refuse = [&](const char* option, const auto& value) {
    fail_usage("{}: {} {}: an OBJ file has neither scenes nor animations; valid for glTF files", path, option, value);
  };
  if (!options.gltf_scene.empty()) refuse("--gltf-scene", options.gltf_scene);
  if (!options.animation.empty()) refuse("--animation", options.animation);
  if (options.params.time != 0.0f) refuse("--time", options.params.time);
}

void refuse_for_gltf(const std::string& path, const SceneFileOptions& options) {
  if (options.params.alpha_from_colour == scene_file_params::Params().alpha_from_colour) return;
  fail_usage("{}: scene.alpha_from_colour: a glTF file says itself what is cut out; valid for OBJ files", path);
}

// Line breaks in what a file says - in names, and so in errors - are shown as text, since messages have lines of their own.
// What has no name gets one by which --cast and the like can mean it.
Scene load_file(const std::filesystem::path& path, bool is_obj, const SceneFileOptions& options) {
  const auto settle = [](const char* kind, auto& items) {
    for (size_t i = 0; i < items.size(); ++i) {
      std::string& name = items[i].name;
      name = name.empty() ? fmt::format("{}[{}]", kind, i) : visible_line(name);
    }
  };
  try {
    Scene scene = is_obj ? load_obj(path, options) : load_gltf(path, options);
    settle("objects", scene.objects), settle("materials", scene.materials), settle("meshes", scene.meshes);
    settle("textures", scene.textures), settle("lights", scene.lights), settle("cameras", scene.cameras);
    return scene;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    throw Error(visible_line(error.what()), error.code());
  }
}

}  // namespace

bool is_builtin_scene(std::string_view name) {
  const auto scenes = builtin_scenes();
  return std::any_of(scenes.begin(), scenes.end(), [&](const BuiltinScene& scene) { return scene.name == name; });
}

Scene load_scene(const std::string& name_or_path, const std::map<std::string, double>& options,
                 const SceneFileOptions& file_options) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != name_or_path) continue;
    if (!file_options.given.empty()) {
      fail_usage("scene.{}: {} is a built-in scene, and this says how a file is read; valid: {}", file_options.given.front(),
                 builtin.name, option_names(builtin));
    }
    Scene scene = builtin.make(complete_options(builtin, options));
    if (!scene.closed_form) add_default_paths(scene);  // charts stand still: their closed forms are for one view and light
    check_scene(scene);
    return scene;
  }
  const std::filesystem::path path(name_or_path);
  const std::string extension = lower_case(path.extension().string());
  const bool is_obj = extension == ".obj", is_gltf = extension == ".gltf" || extension == ".glb";
  if (!is_obj && !is_gltf) {
    fail_usage("{}: neither a built-in scene nor a file that can be read; valid: {}; or a path ending in .obj, .gltf or .glb",
               name_or_path, builtin_names());
  }
  if (!options.empty()) {
    fail_usage("scene.{}: a scene from a file has no such option; valid: {}", options.begin()->first,
               fmt::join(scene_file_option_names(), ", "));
  }
  is_obj ? refuse_for_obj(name_or_path, file_options) : refuse_for_gltf(name_or_path, file_options);
  const WarningLimit limit;
  Scene scene = load_file(path, is_obj, file_options);
  add_default_paths(scene);
  return scene;
}

}  // namespace gnomon
