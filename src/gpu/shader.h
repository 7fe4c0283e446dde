// SPIR-V by name: what the build compiled and linked in, or what took its place while the program runs.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

// The words of a shader by its path below src/ ("frame/shading/shade.comp"), or of a generated kernel
// ("resolve/single/pcf.comp"). Callable from any thread, as all here.
std::vector<uint32_t> find_shader(std::string_view name);
// All names that find_shader was asked for since the program began.
std::set<std::string> shaders_in_use();

// Words that stand in for those of the build. Pipelines that exist keep what they were made from.
using ShaderWords = std::map<std::string, std::vector<uint32_t>, std::less<>>;
ShaderWords replaced_shaders();
// All of them; an empty map: every shader is the build's again.
void set_replaced_shaders(ShaderWords words);

// Of the build only. Throws Error for a name that it does not have.
std::span<const uint32_t> built_in_shader(std::string_view name);

}  // namespace gnomon
