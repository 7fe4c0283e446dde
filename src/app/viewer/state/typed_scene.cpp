#include "app/viewer/state/typed_scene.h"

#include "base/percent_encoding.h"

namespace gnomon::viewer {
namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view k_blanks = " \t\r\n";
  const size_t begin = text.find_first_not_of(k_blanks);
  return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(k_blanks) + 1 - begin);
}

std::string_view without_quotes(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\'');
  return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string typed_scene(std::string_view typed, const std::filesystem::path& home) {
  const std::string_view text = without_blanks(without_quotes(without_blanks(typed)));
  constexpr std::string_view k_address = "file://", k_this_host = "localhost/", k_in_home = "~/";
  if (text.starts_with(k_address)) {
    std::string_view path = text.substr(k_address.size());
    if (path.starts_with(k_this_host)) path.remove_prefix(k_this_host.size() - 1);
    return percent_decoded(path);
  }
  if (text.starts_with(k_in_home) && !home.empty()) return (home / text.substr(k_in_home.size())).string();
  return std::string(text);
}

}  // namespace gnomon::viewer
