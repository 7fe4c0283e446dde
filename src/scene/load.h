// Scenes by name or path.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// A built-in name ("courtyard", "chart/sphere") or a path to .obj, .gltf or .glb. `options` are the built-in scene's own
// numbers ("gap" of chart/slab), empty for files. Shows progress. Throws Error: usage for an unknown name or option,
// failure for a bad file (message: "path:line: what is wrong; what would be valid", or "path: JSON place: ...").
Scene load_scene(const std::string& name_or_path, const std::map<std::string, double>& options = {});

// Whether the alpha channel of an OBJ file's colour picture cuts holes where the file does not say (no map_d).
enum class AlphaFromColour { automatic, on, off };
struct SceneFileOptions {
  AlphaFromColour alpha_from_colour = AlphaFromColour::automatic;
};

Scene load_obj(const std::filesystem::path& path, const SceneFileOptions& options = {});
Scene load_gltf(const std::filesystem::path& path);

// The same from memory, for the fuzz targets; files that the scene refers to are looked for in `folder` (empty: not found).
Scene load_obj_from_memory(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                           const SceneFileOptions& options = {});
Scene load_gltf_from_memory(std::span<const std::byte> bytes, const std::string& name, const std::filesystem::path& folder);

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
