// Scenes by name or path.
#include "scene/load.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
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

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

Scene load_scene(const std::string& name_or_path, const std::map<std::string, double>& options) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != name_or_path) continue;
    Scene scene = builtin.make(complete_options(builtin, options));
    if (!scene.closed_form) add_default_paths(scene);  // charts stand still: their closed forms are for one view and light
    check_scene(scene);
    return scene;
  }
  const std::filesystem::path path(name_or_path);
  const std::string extension = lower_extension(path);
  const bool is_obj = extension == ".obj", is_gltf = extension == ".gltf" || extension == ".glb";
  if (!is_obj && !is_gltf) {
    fail_usage("{}: neither a built-in scene nor a file that can be read; valid: {}; or a path ending in .obj, .gltf or .glb",
               name_or_path, builtin_names());
  }
  if (!options.empty()) fail_usage("scene.{}: a scene from a file has no options", options.begin()->first);
  Scene scene = is_obj ? load_obj(path) : load_gltf(path);
  add_default_paths(scene);
  return scene;
}

}  // namespace gnomon
