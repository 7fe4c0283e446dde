// What the user is told though nothing failed.
#pragma once

#include <span>
#include <string>

namespace gnomon::viewer {

// How many warnings opening a scene gave, and the first ones; empty: none.
std::string warnings_notice(const std::string& scene, std::span<const std::string> warnings);

// Of a picture that shows more than its command draws.
std::string picture_notice(const std::string& path, const std::string& drawn_over);

}  // namespace gnomon::viewer
