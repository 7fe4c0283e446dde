// Which extensions of glTF a file may require.
#pragma once

#include <span>
#include <string_view>

namespace gnomon {

// By name, in alphabetical order.
std::span<const std::string_view> read_extensions();
bool is_read_extension(std::string_view name);

// Of an extension that is not read: it may change colours and meanings, but nothing of what stands where.
bool cannot_change_shape(std::string_view name);

}  // namespace gnomon
