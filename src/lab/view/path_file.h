// Paths of cameras and suns as JSON files (docs/scene_files.md, "Path files").
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/path.h"

namespace gnomon {

// What was recorded at one time: of a camera, of a sun, or of both.
struct Recording {
  std::optional<CameraPath> camera;
  std::optional<RecordedSun> sun;
};

// Throws Error (usage) for what is no path, naming file, key and what would be valid.
Recording read_recording(const std::filesystem::path& path);
Recording parse_recording(std::string_view json, const std::string& where);
// As a file: parse_recording gives the same paths again, directions of a sun to a ten-thousandth of a degree.
std::string recording_text(const Recording& recording);

// The one or the other of a file. Throws Error (usage) where it has none.
CameraPath read_camera_path(const std::filesystem::path& path);
RecordedSun read_sun_path(const std::filesystem::path& path);

}  // namespace gnomon
