// One picture of one technique.
#pragma once

#include <filesystem>

#include "lab/session.h"

namespace gnomon {

enum class Picture { shaded, mask, error, reference };

struct RenderOptions {
  ViewOptions view;
  std::string technique;
  Picture picture = Picture::shaded;
  std::filesystem::path output;  // .png (display values) or .exr (scene-linear colour; mask and reference: visibility)
};

void render(Device& device, const RenderOptions& options, const Settings& settings);

}  // namespace gnomon
