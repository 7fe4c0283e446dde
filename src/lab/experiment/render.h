// One picture of one technique, or a sequence along paths.
#pragma once

#include <filesystem>

#include "lab/experiment/reference_set.h"
#include "lab/view/session.h"

namespace gnomon {

enum class Picture { shaded, mask, error, reference };

struct RenderOptions {
  ViewOptions view;
  std::vector<std::string> techniques;  // each light takes the first that supports its kind
  Picture picture = Picture::shaded;
  Truth against = k_truths[0];  // of error and reference; hard where the light has no size and it is area
  // 0: one picture. Else as many, `output` with _0000, _0001, ... before its extension, evenly over the paths (the camera's is
  // `walk` where neither is named). seconds 0: each path from end to end; else the first `seconds` of each.
  uint32_t frames = 0;
  std::string path, sun_path;
  double seconds = 0.0;
  std::filesystem::path output;  // .png (display values) or .exr (scene-linear colour; mask and reference: visibility)
};

void render(Device& device, const RenderOptions& options, const Settings& settings);

}  // namespace gnomon
