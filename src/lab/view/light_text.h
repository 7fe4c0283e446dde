// Lights written on the command line, for scenes that lack the one that is wanted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace gnomon {

// One of
//   sun:AZIMUTH,ELEVATION   point:X,Y,Z   spot:X,Y,Z:TX,TY,TZ   projector:X,Y,Z:TX,TY,TZ     (degrees; metres; T: what it
//   points at)
// then, if need be, :key=value,... with the keys that k_light_text_help names. nullopt where the text does not begin with a
// kind and a colon. Throws Error (usage) for what is wrong after that, naming what would be valid.
std::optional<Light> parse_light(std::string_view text);

// The inverse: parse_light gives that light again, numbers outside what it takes moved to its bounds. A spot or a projector
// points at what is `reach_m` away. The name must not hold any of k_not_in_light_names.
std::string light_text(const Light& light, float reach_m = 1.0f);
// How far away the target of such a text is; 1 where it has none.
float light_reach(std::string_view text);
inline constexpr std::string_view k_not_in_light_names = ",:@=";

inline constexpr const char* k_light_text_help =
    "sun:azimuth,elevation, point:x,y,z, spot:x,y,z:tx,ty,tz or projector:x,y,z:tx,ty,tz, then :key=value,... with intensity, "
    "colour=r/g/b, "
    "name, angular_diameter (sun, projector), radius, range (point, spot), inner, outer (spot, half angles in degrees), beam "
    "(projector)";

// Three numbers with that character between them, and nothing else.
std::optional<vec3> parse_vec3(std::string_view text, char separator = ',');

// The way the light travels from a sun at `azimuth` (clockwise from -Z seen from above) and `elevation`, degrees.
vec3 sun_direction(float azimuth, float elevation);
// Its inverse: azimuth from -180 to 180, elevation from -90 to 90.
glm::dvec2 sun_angles(const vec3& direction);

}  // namespace gnomon
