#include "base/user_folder.h"

#include <cstdlib>

namespace gnomon {
namespace {

std::filesystem::path from_environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

}  // namespace

std::filesystem::path home_folder() { return from_environment("HOME"); }

std::filesystem::path user_folder(UserFolder folder) {
  const bool cache = folder == UserFolder::cache;
  const auto named = from_environment(cache ? "XDG_CACHE_HOME" : "XDG_STATE_HOME");
  if (!named.empty()) return named / "gnomon";
  const auto home = home_folder();
  return home.empty() ? home : home / (cache ? ".cache" : ".local/state") / "gnomon";
}

}  // namespace gnomon
