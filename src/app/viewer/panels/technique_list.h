// The list of all techniques for a kind of light, wherever one is chosen.
#pragma once

#include "shadow/technique.h"

namespace gnomon::viewer {

// `label`: as ImGui takes it; `name`: in the status file. Returns what the user chose in this frame; null: nothing.
const TechniqueSpec* show_technique_list(const char* label, const char* name, const TechniqueSpec* shown, LightKind kind);

}  // namespace gnomon::viewer
