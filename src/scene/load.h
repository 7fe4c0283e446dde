// Scenes by name or path.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"
#include "scene/scene.h"

namespace gnomon {

namespace scene_file_params {
#define GNOMON_PARAMS_FILE "scene/file.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace scene_file_params

// How a file is read: `--set scene.KEY=VALUE`. Built-in scenes have options of their own instead.
struct SceneFileOptions {
  scene_file_params::Params params;
  std::string gltf_scene;          // name or number of one of a glTF file's scenes; empty: the file's default
  std::string animation;           // name or number; empty: the first
  std::vector<std::string> given;  // names of what the user set, for the message where a scene has none of these
};

// The options that are texts; the others are in scene/file.params.
struct SceneFileText {
  std::string_view name;
  std::string SceneFileOptions::*value;
};
inline constexpr SceneFileText k_scene_file_texts[] = {{"gltf_scene", &SceneFileOptions::gltf_scene},
                                                       {"animation", &SceneFileOptions::animation}};

// A built-in name ("courtyard", "chart/sphere") or a path to .obj, .gltf or .glb. `options` are the built-in scene's own
// numbers ("gap" of chart/slab), empty for files. Shows progress. Throws Error: usage for an unknown name or option,
// failure for a bad file (message: "path:line: what is wrong; what would be valid", or "path: JSON place: ...").
Scene load_scene(const std::string& name_or_path, const std::map<std::string, double>& options = {},
                 const SceneFileOptions& file_options = {});
bool is_builtin_scene(std::string_view name);

Scene load_obj(const std::filesystem::path& path, const SceneFileOptions& options = {});
Scene load_gltf(const std::filesystem::path& path, const SceneFileOptions& options = {});

// The same from memory, for the fuzz targets; files that the scene refers to are looked for in `folder` (empty: not found).
Scene load_obj_from_memory(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                           const SceneFileOptions& options = {});
Scene load_gltf_from_memory(std::span<const std::byte> bytes, const std::string& name, const std::filesystem::path& folder,
                            const SceneFileOptions& options = {});

struct BuiltinOption {
  std::string name;
  double default_value, min, max;
  std::string help;  // ends in "[unit]" where there is one
};
struct BuiltinScene {
  std::string name;
  std::string summary;  // one sentence for `gnomon list scenes`
  std::vector<BuiltinOption> options;
  Scene (*make)(const std::map<std::string, double>& options);  // every option present and in range
};
// Ordered by name.
std::span<const BuiltinScene> builtin_scenes();

}  // namespace gnomon
