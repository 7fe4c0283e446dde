// What a shader's words say about themselves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon {

// Byte offsets of the members of its push constants, in their order; empty where it has none.
std::vector<uint32_t> push_constant_offsets(std::span<const uint32_t> spirv);

}  // namespace gnomon
