// SPIR-V that the build compiled and linked in.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace gnomon {

// The words of a shader by its path below src/ ("frame/shade.comp"), or of a generated kernel ("resolve/single/pcf.comp").
std::span<const uint32_t> find_shader(std::string_view name);

}  // namespace gnomon
