// Where the program keeps what belongs to the user, not to a project (XDG base directories).
#pragma once

#include <filesystem>

namespace gnomon {

// The user's home; empty where there is none.
std::filesystem::path home_folder();

enum class UserFolder { cache, state };

// This program's own: $XDG_CACHE_HOME/gnomon, or ~/.cache/gnomon; $XDG_STATE_HOME/gnomon, or ~/.local/state/gnomon. Empty where
// there is no home. It need not exist.
std::filesystem::path user_folder(UserFolder folder);

}  // namespace gnomon
