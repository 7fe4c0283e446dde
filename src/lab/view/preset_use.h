// Presets against what the program has: techniques, parameters, scenes.
#pragma once

#include "lab/plan/preset.h"
#include "lab/view/session.h"

namespace gnomon {

// Throws Error (usage), naming the preset, for a technique, scene or setting that there is not, or a value out of range.
void check_preset(const Preset& preset);

// The same assignments, with the preset's name in errors.
void assign_preset(Settings& settings, const Preset& preset);

// Writes scene, size, samples, camera and lights where the preset has them.
void apply_view(const Preset& preset, ViewOptions& view);

// Everything in force: all parameters of the techniques, of frame, reference and measure, and of light, camera and scene what
// was set; for single lights what was given for them.
Preset effective_preset(const ViewOptions& view, const std::vector<std::string>& techniques, const Settings& settings);

}  // namespace gnomon
