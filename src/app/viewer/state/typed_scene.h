// A scene as a user types or pastes it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gnomon::viewer {

// Without blanks and quotes around it; "~/a.obj" in `home`, where there is one; "file:///a%20b.obj" as a path. A built-in name
// is itself.
std::string typed_scene(std::string_view typed, const std::filesystem::path& home);

}  // namespace gnomon::viewer
