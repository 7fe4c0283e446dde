// Casting by name: what the user says of the shadows of objects and materials ("ground*=off").
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// Each rule is GLOB=on or GLOB=off and says whether the objects and materials of that name cast. GLOB is a name as it stands
// where there is one, else a pattern (as of fnmatch(3)). Where
// several fit a part of an object, by the object's or its material's name, the last counts; none: the scene's own word.
// Replaces the rules of an earlier call. Throws Error (usage), and the scene is then unchanged, for a rule that is malformed
// or fits nothing.
// `sources`: of rules that do not come from --cast, the file that they stand in, for the message.
using CastSources = std::map<std::string, std::string>;
void apply_casting(Scene& scene, std::span<const std::string> rules, const CastSources& sources = {});

// Throws Error (usage) for a rule that is malformed; `source`: the file that it stands in, or empty.
void check_cast_rule(const std::string& rule, const std::string& source);

// Whether any part of it casts.
bool object_casts(const Scene& scene, const Object& object);

// The rules, and one more for just that name, which takes the place of an earlier one for it.
void set_cast(std::vector<std::string>& rules, const std::string& name, bool on);

}  // namespace gnomon
