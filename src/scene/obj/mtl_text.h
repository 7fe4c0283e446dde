// Material libraries (MTL) as text: the statements that shadows and their colours need.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/maths.h"

namespace gnomon {

// A map statement: the picture's name as the file has it, and the options that are heeded.
struct MtlPicture {
  std::string name;
  vec2 offset = vec2(0.0f), scale = vec2(1.0f);  // -o, -s: of a v that runs upward
  bool clamp = false;
  bool inverted = false;  // map_Tr: of transparency
  float bump_multiplier = 1.0f;
};

struct MtlMaterial {
  std::string name;
  vec3 diffuse = vec3(0.6f);  // the value of a material without Kd
  vec3 specular = vec3(0.0f), emission = vec3(0.0f);
  float shininess = 1.0f, dissolve = 1.0f;
  MtlPicture colour, alpha, normal, bump;  // map_Kd, map_d (map_opacity, map_Tr), norm, map_Bump
};

// In the order of the file. What cannot be read as it stands is a warning that names `file` and the line, and what is used
// instead: a material library is never a reason to refuse a scene.
std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file);

}  // namespace gnomon
