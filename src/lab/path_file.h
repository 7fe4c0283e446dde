// Camera paths as JSON files (docs/scene_files.md, "Camera paths").
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace gnomon {

// Throws Error (usage) for what is no path, naming file, key and what would be valid.
CameraPath read_camera_path(const std::filesystem::path& path);
CameraPath parse_camera_path(std::string_view json, const std::string& where);
// As a file: parse_camera_path gives the same path again.
std::string camera_path_text(const CameraPath& path);

}  // namespace gnomon
