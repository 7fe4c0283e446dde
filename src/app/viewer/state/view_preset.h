// A state as a preset, which `--preset` reads, and the other way round.
#pragma once

#include "app/viewer/state/view_state.h"
#include "lab/plan/preset.h"

namespace gnomon::viewer {

// Everything in force; the picture of `gnomon render --preset` with it is the same.
Preset preset_of(const ViewState& state, uvec2 size);

// The state as if the viewer had been started with the preset; it keeps its scene and the size of its picture. Of a preset for
// another scene, and with `keep_view`, only techniques, samples and their settings are taken: camera and lights stay. Throws
// Error (usage) where a setting or technique is wrong.
ViewState with_preset(const ViewState& state, const Preset& preset, bool keep_view);

bool for_other_scene(const ViewState& state, const Preset& preset);

}  // namespace gnomon::viewer
