// Casting by name: what the user says of the shadows of objects and materials ("ground*=off").
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// Each rule is GLOB=on or GLOB=off (as of fnmatch(3)) and says whether the objects and materials of that name cast. Where
// several fit a part of an object, by the object's or its material's name, the last counts; none: the scene's own word.
// Replaces the rules of an earlier call. Throws Error (usage), and the scene is then unchanged, for a rule that is malformed
// or fits nothing.
void apply_casting(Scene& scene, std::span<const std::string> rules);

// Whether any part of it casts.
bool object_casts(const Scene& scene, const Object& object);

// The rules, and one more for just that name, which takes the place of an earlier one for it.
void set_cast(std::vector<std::string>& rules, const std::string& name, bool on);

}  // namespace gnomon
